// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fill/projected_half.h"

#include <span>
#include <vector>

namespace moldwright {

/// Finds the faces of a projected half above a point: squares of the grid, each with the faces whose shadow
/// reaches into it. Holds a reference to the half.
class FaceGrid {
public:
    explicit FaceGrid(const ProjectedHalf& half);

    /// The highest face above p; −1 where there is none. Of equals the one of lowest index.
    [[nodiscard]] int topAt(const Eigen::Vector2d& p) const;

    /// Whether a face other than the two named lies strictly above height z at p.
    [[nodiscard]] bool coveredAt(const Eigen::Vector2d& p, double z, const std::array<int, 2>& except) const;

private:
    [[nodiscard]] std::span<const int> facesNear(const Eigen::Vector2d& p) const;
    [[nodiscard]] int indexOf(double coordinate) const;
    template <class Visit>
    void visitSquares(const ShadowFace& face, Visit visit) const;

    const ProjectedHalf& m_half;
    int m_side = 1;     ///< squares along one side
    double m_width = 1; ///< of a square
    std::vector<int> m_first;
    std::vector<int> m_faces;
};

} // namespace moldwright

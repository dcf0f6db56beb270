// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fill/draft_cone.h"
#include "fill/height_field.h"

#include <vector>

namespace moldwright {

/// What leans against the walls and the steep triangles of a filled half, from their upper rims outwards to
/// the plane.
class Skirts {
public:
    /// Skirts fall as `cone` does; triangles steeper than `limit` allows get them as walls do.
    Skirts(const HeightField& field, const DraftCone& cone, const DraftCone& limit);

    /// The highest skirt at p; below 0 where none reaches.
    [[nodiscard]] double heightAt(const Eigen::Vector2d& p) const;

    /// Points that a skirt starts from: 1 per point of the field.
    [[nodiscard]] const std::vector<char>& starts() const { return m_starts; }

private:
    struct Rim {
        Eigen::Vector2d from;
        Eigen::Vector2d along;
        Eigen::Vector2d height; ///< at both ends
    };

    void addRim(const HeightField& field, HeightField::Vertex a, HeightField::Vertex b, double heightA,
                double heightB);
    void makeGrid();
    [[nodiscard]] int indexOf(double coordinate) const;
    template <class Visit>
    void visitSquares(const Rim& rim, Visit visit) const;

    DraftCone m_cone;
    std::vector<Rim> m_rims;
    std::vector<char> m_starts;
    int m_side = 1; ///< squares along one side
    std::vector<int> m_first;
    std::vector<int> m_inSquare;
};

/// Whether a triangle is steeper than the cone allows.
[[nodiscard]] bool tooSteep(const HeightField& field, HeightField::Face f, const DraftCone& cone);

/// Gradient of a triangle of the field.
[[nodiscard]] Eigen::Vector2d gradientOf(const HeightField& field, HeightField::Face f);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <array>
#include <vector>

namespace moldwright {

/// Lets a fine surface follow a coarse one that stands in for it: every fine point is tied to the coarse face
/// nearest to it and moves as the neighbourhoods of that face's three points move, affinely each, blended by
/// its place on the face. A rigid motion of the coarse surface is carried over exactly; the detail of the
/// fine one turns and stretches with it. In the manner of [Sumner 2007], with the coarse points as nodes.
class SurfaceBinding {
public:
    /// `coarse`: at rest. `fine`: n×3, at rest, same frame. `seeds`: per fine point a coarse point near it
    /// along the surface; the nearest face is sought from there by steps between neighbours, so that a point
    /// is never tied to another sheet that only lies near in space.
    SurfaceBinding(IndexedMesh coarse, Points fine, const std::vector<int>& seeds);

    /// The fine points when the coarse ones are at X (m×3).
    [[nodiscard]] Points carry(const Points& X) const;

private:
    struct Tie {
        std::array<int, 3> points;
        Eigen::Vector3d weights;
    };

    IndexedMesh m_coarse;
    Points m_fine;
    std::vector<int> m_ringStart; ///< of each coarse point, into m_ring
    std::vector<int> m_ring;      ///< faces about each coarse point
    std::vector<Tie> m_ties;      ///< per fine point

    [[nodiscard]] std::pair<int, Eigen::Vector3d> nearestFrom(const Eigen::Vector3d& p, int seed) const;
    [[nodiscard]] std::vector<Eigen::Matrix3d> motionsOfPoints(const Points& X) const;
};

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <array>
#include <vector>

namespace moldwright {

/// A surface of a mold and where it stands. Copies of a cavity share their mesh.
struct PlacedSurface {
    SharedMesh mesh;                                  ///< every point is used, and no two are equal
    Eigen::Vector2d offset = Eigen::Vector2d::Zero(); ///< mm
    bool insideOut = false;
};

/// Surfaces put together.
struct SurfaceSum {
    IndexedMesh mesh;
    std::vector<std::array<int, 2>> open; ///< edges that one face has, as pairs of points, ascending
};

/// Surfaces that meet along their borders at most, in one: equal points of borders become one, all others
/// are only copied. O(m).
[[nodiscard]] SurfaceSum sumOf(const std::vector<PlacedSurface>& surfaces);

} // namespace moldwright

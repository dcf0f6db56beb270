// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <array>
#include <vector>

namespace moldwright {

/// The tetrahedra of a Delaunay triangulation.
struct DelaunayCells {
    std::vector<std::array<int, 4>> corners;    ///< points of each, ascending; the cells in ascending order
    std::vector<std::array<int, 4>> neighbours; ///< the cell opposite each corner; −1 outside the hull
};

/// Delaunay triangulation of points in general position (CGAL, exact predicates). Points that coincide are
/// taken once. What is numbered how depends on the order of the points alone, not on where they lie.
[[nodiscard]] DelaunayCells delaunay(const Points& points);

} // namespace moldwright

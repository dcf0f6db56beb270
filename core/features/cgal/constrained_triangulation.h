// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace moldwright {

/// Triangles of the region that closed outlines bound: the points inside an odd number of them. Counter-
/// clockwise, indices into `points`; every segment is an edge, no point is added. None when segments cross or
/// points coincide. Constrained Delaunay triangulation of CGAL; deterministic.
[[nodiscard]] std::optional<Triangles>
triangulateRegion(const std::vector<Eigen::Vector2d>& points,
                  const std::vector<std::array<int, 2>>& outlineSegments);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <Eigen/Geometry>

#include <vector>

namespace moldwright {

/// Points of a mesh that lie together, and the box about them.
struct PointGroup {
    Eigen::AlignedBox3d box;
    std::vector<int> points; ///< ascending
};

/// All points in groups of at most `most` near ones: a search leaves out those whose box says that nothing in
/// them is better than what it has. Every point is in one group. O(n log n).
[[nodiscard]] std::vector<PointGroup> groupsOfPoints(const Points& V, int most = 64);

} // namespace moldwright

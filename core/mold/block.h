// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "mold/mold.h"

#include <Eigen/Geometry>

namespace moldwright {

/// The box that both halves are cut from, mold's frame, mm: floats, centred in x and y over the origin.
using Block = Eigen::AlignedBox3d;

/// The block for a cast placed in the mold's frame: walls, floor and ceiling of `settings` at least, sizes
/// rounded up to its step.
[[nodiscard]] Block blockAround(const IndexedMesh& placedCast, const MoldSettings& settings);

/// Least steel between the cavity and the outside of the block, mm, and the cavity point that has it.
struct LeastWall {
    double thickness = 0;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
};
[[nodiscard]] LeastWall leastWall(const IndexedMesh& placedCast, const Block& block);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <array>
#include <vector>

namespace moldwright::test {

/// The surface of unit cubes that stand at the given whole numbers, shared faces removed: shapes with volumes
/// known by counting. The cubes must not meet in an edge or a corner alone.
IndexedMesh voxels(const std::vector<std::array<int, 3>>& cubes);

} // namespace moldwright::test

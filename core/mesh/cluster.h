// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

namespace moldwright {

/// `mesh` reduced to roughly `targetFaces` by merging the points of each cell of a cubic grid; the mesh
/// itself when it has no more. Each cell's point is where the planes of its faces meet best, so that edges
/// and curved areas stay in place. Much faster than decimate(), and good for sums over the surface: every
/// integral over a closed mesh still closes, but thin places may touch, and edges may have more than two
/// faces. O(n). [Lindstrom 2000]
[[nodiscard]] IndexedMesh cluster(const IndexedMesh& mesh, int targetFaces);

} // namespace moldwright

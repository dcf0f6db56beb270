// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

namespace moldwright {

/// `mesh` after `rounds` of Loop's subdivision (OpenMesh): every face becomes four and the surface smoother,
/// coming to lie a little inside convex places. Closed stays closed, genus and components stay; points of the
/// input keep their index, though not their place. Precondition: manifold, oriented, rounds ≥ 0. [Loop 1987]
[[nodiscard]] IndexedMesh subdivide(const IndexedMesh& mesh, int rounds);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

namespace moldwright {

/// `mesh` reduced to about `targetFaces` by quadric edge collapses (OpenMesh) that flip no normal; the mesh
/// itself when it has no more. Closed stays closed, genus and components stay. Precondition: manifold,
/// oriented.
[[nodiscard]] IndexedMesh decimate(const IndexedMesh& mesh, int targetFaces);

} // namespace moldwright

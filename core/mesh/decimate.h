// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

/// `mesh` reduced to about `targetFaces` by collapses of the edges that cost least
/// [Garland & Heckbert 1997], none of which turns a face over; the mesh
/// itself when it has no more. Closed stays closed, genus and components stay. Precondition: manifold,
/// oriented.
[[nodiscard]] IndexedMesh decimate(const IndexedMesh& mesh, int targetFaces);

/// A reduced mesh, and where the points of the original went.
struct Reduction {
    IndexedMesh mesh;
    std::vector<int> pointNow; ///< per point of the original: the point of `mesh` that it was merged into
};

/// decimate(), keeping account of its points. `kept`: 1 for points that stay where they are, with the edges
/// between them; no face comes to lie wholly on them. Empty: none.
[[nodiscard]] Reduction reduce(const IndexedMesh& mesh, int targetFaces, const std::vector<char>& kept = {});

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

/// A mesh of the same shape, and the face of the first one that each of its faces is a part of.
struct FinerMesh {
    IndexedMesh mesh;
    std::vector<int> from;
};

/// `mesh` with long edges cut in their middles until no edge of a wanted face is longer than `longest` mm;
/// other faces are cut only as far as their neighbours ask, so that what was closed stays so. The points of
/// `mesh` keep their numbers. `wanted`: per face, 0 or not. O(m log m) of what comes out.
[[nodiscard]] FinerMesh withFinerFaces(const IndexedMesh& mesh, const std::vector<char>& wanted,
                                       double longest);

} // namespace moldwright

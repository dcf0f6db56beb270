// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

/// What turning faces so that all agree and look outward came to.
struct Orientation {
    std::vector<int> turned; ///< faces whose corners were reversed, ascending
    std::vector<int>
        contradiction; ///< two neighbours that cannot agree; empty when the surface has two sides
};

/// Reverses faces of `mesh` until neighbours agree and each connected piece encloses a positive volume; on a
/// one-sided surface (a Klein bottle) nothing is changed. Precondition: every edge has exactly two faces.
Orientation orientOutward(IndexedMesh& mesh);

} // namespace moldwright

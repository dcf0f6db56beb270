// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

namespace moldwright {

/// Points on a surface, dense enough for its medial axis: its own points, at most some 15,000 of them, and,
/// where they lie sparser than 4,000 spread evenly would, more on its edges and faces. Each is moved a hair,
/// by `jitter` (mesh units) at most, so that no five lie on one sphere; that and the choice depend on the
/// seed and go with the surface when it is turned or moved.
[[nodiscard]] Points surfaceSamples(const IndexedMesh& mesh, double jitter, unsigned seed);

} // namespace moldwright

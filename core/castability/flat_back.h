// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

/// The parting planes that lie on a flat back: a plane face patch of at least 1 % of the surface with all of
/// the part on one side of it; n looks into the part, so that side 2 is the flat face alone.
[[nodiscard]] std::vector<PartingPlane> flatBackPlanes(const IndexedMesh& mesh);

} // namespace moldwright

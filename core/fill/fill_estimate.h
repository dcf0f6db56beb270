// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

namespace moldwright {

/// About how much filling all would take at a state, as fill() counts it: what lies between each half's
/// outermost surface along its direction and the plane, less the part; a share of the part's volume. Seen in
/// a raster, good to a few hundredths: to choose planes by, in milliseconds. `mesh` and state in the part's
/// frame. Precondition: closed, outward; volume > 0.
[[nodiscard]] double estimatedFill(const IndexedMesh& mesh, const MoldState& state);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/design_run.h"
#include "design/parting.h"

namespace moldwright {

/// Tells each obstruction of a part at `state` what would take it away, with the facts: a plane at which
/// nothing is in the way, where one is found near or among the best; how much filling it takes, or joining
/// pieces that are apart; a point to pin to the plane. What is not known to help is left out.
void offerRemedies(ObstructedPart& obstructed, const IndexedMesh& shape, const MoldState& state,
                   DesignRun& run);

} // namespace moldwright

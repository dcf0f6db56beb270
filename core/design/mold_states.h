// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/design_run.h"

#include <vector>

namespace moldwright {

/// The planes a design may try, with their directions.
struct MoldStates {
    std::vector<MoldState> passing;        ///< the topological certificate holds; to be tried in this order
    MoldState best;                        ///< of least energy, whether it passes or not
    std::vector<Obstruction> obstructions; ///< of `best`; empty when some plane passes
};

/// The given plane alone, or the best planes of `shape` (part frame). The preferred plane comes first; where
/// that does not serve, the preference for volume on both sides does not count any more, and the others
/// follow by their energy alone. Errors: Cancelled.
[[nodiscard]] Result<MoldStates> moldStatesFor(const IndexedMesh& shape, DesignRun& run);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "design/filling.h"
#include "mesh/indexed_mesh.h"

#include <optional>
#include <vector>

namespace moldwright {

/// Undercuts that were found, and of what.
struct KnownUndercuts {
    SharedMesh part;
    std::optional<MoldState> state;
    std::vector<FillableUndercut> list;
    std::vector<SharedMesh> walls; ///< of each
};

} // namespace moldwright

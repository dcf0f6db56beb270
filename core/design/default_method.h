// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/design_run.h"

namespace moldwright {

/// The default pipeline (ARCHITECTURE.md, "From part to cast"): planes that pass the topological certificate
/// are tried in turn until one ends castable with its limbs kept; what cannot be bent is filled where the
/// request allows it. Errors as of design().
[[nodiscard]] Result<DesignResult> designByBending(DesignRun& run);

} // namespace moldwright

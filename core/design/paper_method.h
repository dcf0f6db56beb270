// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/design_run.h"

namespace moldwright {

/// The paper's method as described: nothing split, restarts, post-processing. It seldom ends castable. Errors
/// as of design().
[[nodiscard]] Result<DesignResult> designAsPublished(DesignRun& run);

} // namespace moldwright

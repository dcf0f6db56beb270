// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/design_run.h"
#include "design/elastoplastic.h"

namespace moldwright {

/// The published deformation of the whole part at a state, with the request's pins and importance. Errors:
/// Worker, Cancelled.
[[nodiscard]] Result<Elastoplastic> elastoplasticAt(const MoldState& state, DesignRun& run);

/// Has the deformation take what the designer changed since the last step, or ends the leg: see
/// DesignRun::hear(). Returns whether it took anything.
[[nodiscard]] bool hearChanges(Elastoplastic& solver, DesignRun& run);

/// Shows where the deformation is.
void showStep(const char* stage, const Elastoplastic& solver, DesignRun& run);

/// The paper's method as described: nothing split, restarts, post-processing. It seldom ends castable. Errors
/// as of design().
[[nodiscard]] Result<DesignResult> designAsPublished(DesignRun& run);

} // namespace moldwright

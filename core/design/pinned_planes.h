// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/design_run.h"

#include <vector>

namespace moldwright {

/// Planes for a part whose pins were given without one, best first: the best planes of the part, and the one
/// that passes nearest to its pins, by their castability energy and the mean square of the pins' distances.
/// Fewer than `count` where there are no more, none when the run was stopped.
[[nodiscard]] std::vector<PartingPlane> planesForPins(DesignRun& run, int count);

} // namespace moldwright

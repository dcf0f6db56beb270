// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "fill/divide_region.h"

namespace moldwright {

/// Divides a region where it is narrow: first by the parting plane, then by planes along the side's
/// direction, across its longest extent where least of it is cut, until nothing is longer than `longest` that
/// can be cut cleanly and as `check` wants it, or the task is stopped.
void divideAtNecks(ChoiceMesh& choices, int region, const Directions& directions, double longest,
                   const Task& task, const CutCheck& check = {});

} // namespace moldwright

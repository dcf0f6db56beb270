// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "deformation/elastic_body.h"

#include <functional>
#include <vector>

namespace moldwright {

/// The body (the plane's frame) bent as a whole, as rigid as possible, so that all `points` have z = 0: they
/// come down together in small steps, and limbs follow as they would if they were held there. `seen` is given
/// the positions every few iterations. Stopped, it returns the positions reached.
[[nodiscard]] Positions drawnIntoPlane(const BodyShape& body, const std::vector<int>& points,
                                       const Task& task,
                                       const std::function<void(const Positions&)>& seen = {});

} // namespace moldwright

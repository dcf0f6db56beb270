// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "pins/medial_mesh.h"

namespace moldwright {

/// A medial axis of unit size reduced to `count` balls that fill nearly the same solid: collapses of the edge
/// that costs least, spikes first [Li 2015]. Among the last, ends and loops stay, so that more balls may be
/// left where there are many. The result need not lie on the axis given. Cancelled tasks end early.
[[nodiscard]] MedialMesh simplify(const MedialMesh& axis, int count, const Task& task);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "mesh/indexed_mesh.h"
#include "pins/medial_mesh.h"

namespace moldwright {

class InsideTest;

/// The medial axis of a solid of about unit size, as the part of its samples' Voronoi diagram that lies
/// inside: some three balls a sample, many of them on spikes towards the surface. Pieces with under a
/// hundredth of the largest one's balls are left out. Cancelled tasks end with an empty one.
[[nodiscard]] MedialMesh medialAxis(const Points& samples, const InsideTest& solid, const Task& task);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "fill/height_field.h"
#include "fill/projected_half.h"

namespace moldwright {

/// The half's outermost surface along its direction, as heights over the plane. Heights at a point that
/// differ by no more than `step` (grid steps) become one, those within it of the plane become 0. Nothing once
/// the task is stopped.
[[nodiscard]] HeightField outermostSurface(const ProjectedHalf& half, double step, const Task& task);

} // namespace moldwright

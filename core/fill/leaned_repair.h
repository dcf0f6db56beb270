// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fill/draft_cone.h"
#include "fill/height_field.h"

namespace moldwright {

/// Makes the body below a leaned half a manifold that ends well within the field: tops that touch the plane
/// and points where the outline meets itself are lifted a little, and points next to the frame about
/// everything get a foot, as `cone` falls. What is put about such points stands no nearer than `near` (grid
/// steps). `field` has one height a point, before and after.
void repairLeaned(HeightField& field, const DraftCone& cone, double near);

} // namespace moldwright

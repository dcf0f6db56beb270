// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fill/draft_cone.h"
#include "fill/height_field.h"

namespace moldwright {

/// A filled half whose walls lean: each becomes a skirt from its upper rim outwards, and so does what is too
/// steep, down to the surface or the plane below. Skirts fall as `aim` does, round convex corners in fans;
/// where `limit` was kept nothing changes. A point has one height in the result. Points nearer than `near`
/// (grid steps) become one.
[[nodiscard]] HeightField leanWalls(const HeightField& field, const DraftCone& aim, const DraftCone& limit,
                                    double near);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fill/height_field.h"

namespace moldwright {

/// Raises heights, always, until the body below them is a manifold: no wall that changes sides along its
/// edge, no vertical line or point of the plane where the solid meets itself, no top that touches the plane
/// within the outline. Where several walls meet in a vertical line the narrowest gap is closed near it.
void makeManifold(HeightField& field);

} // namespace moldwright

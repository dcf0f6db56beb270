// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/design.h"

#include <vector>

namespace moldwright {

/// Pins of a part where they are in a bent shape of it, the same points and faces: those on the surface with
/// the nearest point, those inside with the best rigid motion of the points about them. Pins of the part
/// itself stay as they are.
[[nodiscard]] std::vector<Pin> carriedPins(std::vector<Pin> pins, const IndexedMesh& part,
                                           const IndexedMesh& shape);

} // namespace moldwright

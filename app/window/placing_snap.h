// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/mold_placing.h"

namespace moldwright {

/// A place near `wish` at which a dragged feature lines up: with another of the same frame, or mirrored to
/// it across the mold's middle lines, where that is within `reach` mm; else in steps of half a millimetre.
[[nodiscard]] Eigen::Vector2d snapped(const Eigen::Vector2d& wish, const PlacedRow& dragged,
                                      const std::vector<PlacedRow>& rows, double reach);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/colours.h"
#include "scene/overlay.h"

#include <vector>

namespace moldwright {

struct ShownSteel;
struct SteelMap;

/// The colour of each face of a half by the steel behind it; what is no wall keeps the half's.
[[nodiscard]] std::vector<scene::Rgb> steelPaint(const SteelMap& map, const std::vector<double>& thickness,
                                                 int side);

/// What the colours mean, in mm, with the limit and the thinnest steel, and the area of each class in both
/// halves. Null: why nothing is painted; `shown`: whether the halves are in view.
[[nodiscard]] scene::PanelContent steelLegend(const ShownSteel* steel, bool shown);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "mold/placed_feature.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace moldwright {

/// What is placed by hand as a list of {"kind": "key", "number": 1, "at": [x, y]}: kinds as in
/// placeableNames, numbers from 1, mm as PlacedFeature::place has them.
[[nodiscard]] nlohmann::ordered_json placedJson(const PlacedFeatures& placed);

/// Reads such a list, or that of a mold.json: entries without "at", which cannot be placed, are passed over,
/// and a feature of several cavities may be named for each. `where` is what a sentence calls the list.
/// Errors: BadInput, naming the entry and what is wrong.
[[nodiscard]] Result<PlacedFeatures> placedFrom(const nlohmann::ordered_json& list, const std::string& where);

} // namespace moldwright

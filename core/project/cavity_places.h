// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "mold/mold_settings.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace moldwright {

/// Places of cavities as a person writes them: "0, 0; 40, 5, 90": x and y in mm, and a turn in degrees where
/// there is one.
[[nodiscard]] std::string cavityPlacesText(const std::vector<CavityPlace>& places);

/// Reads such a text; a semicolon or a line's end stands between places. Errors: BadInput, with the place
/// that cannot be read.
[[nodiscard]] Result<std::vector<CavityPlace>> cavityPlacesOf(std::string_view text);

/// The same as a list of {"at": [x, y], "turn_deg": t}, and back. Errors: BadInput, with the entry's number.
[[nodiscard]] nlohmann::ordered_json cavityPlacesJson(const std::vector<CavityPlace>& places);
[[nodiscard]] Result<std::vector<CavityPlace>> cavityPlacesFrom(const nlohmann::ordered_json& list);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/mold_settings.h"

#include <nlohmann/json_fwd.hpp>

namespace moldwright {

/// The settings as they stand in a project file: lengths in mm, angles in degrees.
[[nodiscard]] nlohmann::ordered_json moldSettingsJson(const MoldSettings& settings);

/// The settings from a project file; what the file does not name, as those of old do not, has its default.
/// Throws as the library does where a value has the wrong type or an unknown name.
[[nodiscard]] MoldSettings moldSettingsFrom(const nlohmann::ordered_json& json,
                                            const MoldSettings& otherwise = {});

} // namespace moldwright

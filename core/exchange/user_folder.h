// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace moldwright {

/// Where the user keeps things of a kind ("materials", "presets"): `$XDG_CONFIG_HOME/moldwright/KIND`, or
/// that in `~/.config`. It need not exist. None when the system names no home.
[[nodiscard]] std::optional<std::filesystem::path> userFolder(const std::string& kind);

} // namespace moldwright

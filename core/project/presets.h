// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "mold/mold_settings.h"

#include <filesystem>
#include <string>
#include <vector>

namespace moldwright {

/// Presets are what a shop sets once: block, layout, channels, keys and holes, press and printer, under a
/// name. Each is a file NAME.json in one folder (see userFolder()). They hold nothing that belongs to one
/// part or material: shrink and density stay as they are when one is taken.

/// The names of the presets in a folder, sorted; none where there is no folder.
[[nodiscard]] std::vector<std::string> presetNames(const std::filesystem::path& folder);

/// `settings` with what the preset says; what it does not name stays. Errors: Usage when there is none of
/// that name, with those there are; BadInput when its file cannot be read or understood.
[[nodiscard]] Result<MoldSettings> withPreset(const MoldSettings& settings,
                                              const std::filesystem::path& folder, const std::string& name);

/// Writes the preset, over one of that name. Errors: Usage when the name cannot be a file's; WriteFailed.
[[nodiscard]] Result<void> savePreset(const std::filesystem::path& folder, const std::string& name,
                                      const MoldSettings& settings);

/// Removes the preset. Errors: Usage when there is none of that name; WriteFailed.
[[nodiscard]] Result<void> removePreset(const std::filesystem::path& folder, const std::string& name);

/// Whether taking the preset would change nothing. False when it cannot be read.
[[nodiscard]] bool presetHolds(const MoldSettings& settings, const std::filesystem::path& folder,
                               const std::string& name);

} // namespace moldwright

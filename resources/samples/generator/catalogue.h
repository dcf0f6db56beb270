// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "samples.h"

#include <filesystem>

namespace moldwright::samples {

/// Writes each sample whose name is in `names` (all when empty) as folder/NAME.ply. Errors: Usage for an
/// unknown name, WriteFailed.
[[nodiscard]] Result<void> writeSamples(const std::filesystem::path& folder,
                                        const std::vector<std::string>& names);

/// Writes folder/samples.json: of each sample in order its file, title, description, size in mm and number
/// of faces, read from the files in the folder. Errors: those of readMesh(), WriteFailed.
[[nodiscard]] Result<void> writeCatalogue(const std::filesystem::path& folder);

} // namespace moldwright::samples

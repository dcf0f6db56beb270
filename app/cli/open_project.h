// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "project/project.h"

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace moldwright::cli {

/// The option that names a variant of a project.
void addVariantOption(CLI::App& app, std::string& variant);

/// The project of a file, or of a folder that `design` wrote, the wanted variant as the current one; an empty
/// name: as it was saved. Errors: as openProject(); Usage for a variant that there is not.
[[nodiscard]] Result<Project> projectAt(const std::filesystem::path& input, const std::string& variant);

} // namespace moldwright::cli

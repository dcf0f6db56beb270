// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/project_file.h"

#include <filesystem>

namespace moldwright::cli {

/// Opens a project file, or the one in a folder that `design` wrote. Errors: as openProject().
[[nodiscard]] inline Result<StoredProject> openProjectOrFolder(const std::filesystem::path& input) {
    return openProject(std::filesystem::is_directory(input) ? input / "project.moldwright" : input);
}

} // namespace moldwright::cli

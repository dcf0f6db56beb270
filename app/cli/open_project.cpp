// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/open_project.h"

#include "project/project_file.h"
#include "project/variants.h"

#include <CLI/CLI.hpp>

namespace moldwright::cli {

void addVariantOption(CLI::App& app, std::string& variant) {
    app.add_option("--variant", variant, "Name of one of the project's variants; else the current one")
        ->type_name("NAME");
}

Result<Project> projectAt(const std::filesystem::path& input, const std::string& variant) {
    const std::filesystem::path file =
        std::filesystem::is_directory(input) ? input / "project.moldwright" : input;
    Result<StoredProject> stored = openProject(file);
    if (!stored)
        return std::unexpected(stored.error());
    return atVariant(std::move(stored->project), variant, file.filename().string());
}

} // namespace moldwright::cli

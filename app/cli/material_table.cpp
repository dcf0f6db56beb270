// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/material_table.h"

#include "exchange/user_folder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace moldwright::cli {

namespace {

namespace fs = std::filesystem;

Result<std::vector<Material>> readTable(const fs::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in)
        return failure(ErrorCode::BadInput, MW_TEXT("cli", "{0} cannot be read."), {file.string()});
    return materialsFrom(text.str(), file.string());
}

/// Installed beside the program, else in the source tree it was built from.
fs::path bundledTable() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path installed =
        program.parent_path().parent_path() / "share/moldwright/materials/materials.json";
    return !error && fs::exists(installed, error) ? installed : fs::path(MOLDWRIGHT_MATERIALS);
}

std::vector<fs::path> ownTables() {
    const std::optional<fs::path> folder = userFolder("materials");
    if (!folder)
        return {};
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(*folder, error))
        if (entry.path().extension() == ".json")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace

Result<std::vector<Material>> materialTable() {
    Result<std::vector<Material>> table = readTable(bundledTable());
    for (const fs::path& file : ownTables()) {
        if (!table)
            break;
        const Result<std::vector<Material>> own = readTable(file);
        if (!own)
            return std::unexpected(own.error());
        table = withOwn(*std::move(table), *own);
    }
    return table;
}

} // namespace moldwright::cli

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "materials/material_table.h"

#include "exchange/mesh_file.h"
#include "exchange/user_folder.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

namespace moldwright {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* ending = ".json";

Result<std::string> textOf(const fs::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in)
        return failure(ErrorCode::BadInput, MW_TEXT("Materials", "{0} cannot be read."), {file.string()});
    return text.str();
}

Result<std::vector<Material>> readTable(const fs::path& file) {
    const Result<std::string> text = textOf(file);
    if (!text)
        return std::unexpected(text.error());
    return materialsFrom(*text, file.string());
}

std::vector<fs::path> ownTables(const MaterialPlaces& places) {
    std::vector<fs::path> files;
    if (!places.own)
        return files;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(*places.own, error))
        if (entry.path().extension() == ending)
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

/// The last of the user's tables that has a material: what that says holds.
Result<std::optional<fs::path>> tableOf(const MaterialPlaces& places, const std::string& id) {
    std::optional<fs::path> found;
    for (const fs::path& file : ownTables(places)) {
        const Result<std::vector<Material>> table = readTable(file);
        if (!table)
            return std::unexpected(table.error());
        if (std::ranges::find(*table, id, &Material::id) != table->end())
            found = file;
    }
    return found;
}

Result<void> write(const fs::path& file, const Json& whole) {
    return writeFileAtomically(file, whole.dump(2) + "\n");
}

/// A table of the user's own without a material, or with another in its place; nothing else changes in it.
Result<void> edit(const fs::path& file, const std::string& id, const Material* instead) {
    const Result<std::string> text = textOf(file);
    if (!text)
        return std::unexpected(text.error());
    Json whole = Json::parse(*text);
    Json& entries = whole.at("materials");
    Json kept = Json::array();
    for (Json& entry : entries)
        if (entry.at("id") != id)
            kept.push_back(std::move(entry));
        else if (instead != nullptr)
            kept.push_back(materialJson(*instead));
    entries = std::move(kept);
    if (!entries.empty())
        return write(file, whole);
    std::error_code error;
    if (!fs::remove(file, error))
        return failure(ErrorCode::WriteFailed, MW_TEXT("Materials", "{0} could not be removed: {1}."),
                       {file.string(), error.message()});
    return {};
}

bool canBeAnId(const std::string& id) {
    constexpr std::size_t longest = 60;
    return !id.empty() && id.size() <= longest && std::ranges::all_of(id, [](unsigned char c) {
        return (std::islower(c) != 0) || (std::isdigit(c) != 0) || c == '-';
    });
}

} // namespace

MaterialPlaces MaterialPlaces::usual() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path installed =
        program.parent_path().parent_path() / "share/moldwright/materials/materials.json";
    const bool isInstalled = !error && fs::exists(installed, error);
    return {isInstalled ? installed : fs::path(MOLDWRIGHT_MATERIALS), userFolder("materials")};
}

Result<std::vector<Material>> ownMaterials(const MaterialPlaces& places) {
    std::vector<Material> all;
    for (const fs::path& file : ownTables(places)) {
        const Result<std::vector<Material>> table = readTable(file);
        if (!table)
            return std::unexpected(table.error());
        all = withOwn(std::move(all), *table);
    }
    return all;
}

Result<std::vector<Material>> materialTable(const MaterialPlaces& places) {
    Result<std::vector<Material>> bundled = readTable(places.bundled);
    const Result<std::vector<Material>> own = ownMaterials(places);
    if (!bundled || !own)
        return std::unexpected(bundled ? own.error() : bundled.error());
    return withOwn(*std::move(bundled), *own);
}

Result<void> saveMaterial(const MaterialPlaces& places, const Material& material) {
    if (const std::optional<Message> why = whyImplausible(material))
        return failure(ErrorCode::Usage, why->text, why->arguments);
    if (!places.own || !canBeAnId(material.id))
        return failure(ErrorCode::Usage,
                       MW_TEXT("Materials", "A material cannot be kept as “{0}”: up to 60 lower-case "
                                            "letters, digits and hyphens can name one."),
                       {material.id});
    const Result<std::optional<fs::path>> table = tableOf(places, material.id);
    if (!table)
        return std::unexpected(table.error());
    if (*table)
        return edit(**table, material.id, &material);
    if (Result<void> made = makeFolder(*places.own); !made)
        return made;
    return write(*places.own / (material.id + ending), {{"materials", {materialJson(material)}}});
}

Result<void> removeMaterial(const MaterialPlaces& places, const std::string& id) {
    Result<std::optional<fs::path>> table = tableOf(places, id);
    if (table && !*table)
        return failure(ErrorCode::Usage, MW_TEXT("Materials", "None of your own materials is {0}."), {id});
    while (table && *table) {
        if (Result<void> done = edit(**table, id, nullptr); !done)
            return done;
        table = tableOf(places, id);
    }
    return table ? Result<void>() : std::unexpected(table.error());
}

std::string freeMaterialId(const std::string& name, const std::vector<Material>& taken) {
    std::string plain;
    for (const unsigned char c : name)
        if (c < 128 && std::isalnum(c) != 0)
            plain += static_cast<char>(std::tolower(c));
        else if (!plain.empty() && plain.back() != '-' && plain.size() < 40)
            plain += '-';
    while (!plain.empty() && plain.back() == '-')
        plain.pop_back();
    plain = plain.empty() ? "material" : plain.substr(0, 40);
    std::string id = plain;
    for (int number = 2; std::ranges::find(taken, id, &Material::id) != taken.end(); ++number)
        id = plain + "-" + std::to_string(number);
    return id;
}

} // namespace moldwright

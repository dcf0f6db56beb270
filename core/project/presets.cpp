// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/presets.h"

#include "exchange/mesh_file.h"
#include "project/mold_settings_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace moldwright {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* ending = ".json";

fs::path fileOf(const fs::path& folder, const std::string& name) {
    return folder / (name + ending);
}

/// Whether a file may be called so on any system, and a person can read it.
bool canBeAName(const std::string& name) {
    constexpr std::size_t longest = 60;
    return !name.empty() && name.size() <= longest && name.front() != '.' && name.front() != ' ' &&
           name.back() != ' ' && std::none_of(name.begin(), name.end(), [](char c) {
               return static_cast<unsigned char>(c) < ' ' ||
                      std::string_view("/\\:*?\"<>|").find(c) != std::string_view::npos;
           });
}

std::unexpected<Error> unknown(const fs::path& folder, const std::string& name) {
    std::string names;
    for (const std::string& there : presetNames(folder))
        names += (names.empty() ? "" : ", ") + there;
    if (names.empty())
        return failure(ErrorCode::Usage,
                       MW_TEXT("Presets", "There is no preset {0}: none has been saved yet in {1}."),
                       {name, folder.string()});
    return failure(ErrorCode::Usage, MW_TEXT("Presets", "There is no preset {0}. There are: {1}."),
                   {name, names});
}

bool isThere(const fs::path& folder, const std::string& name) {
    std::error_code error;
    return canBeAName(name) && fs::is_regular_file(fileOf(folder, name), error);
}

} // namespace

std::vector<std::string> presetNames(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (entry.path().extension() == ending && canBeAName(entry.path().stem().string()))
            names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

Result<MoldSettings> withPreset(const MoldSettings& settings, const fs::path& folder,
                                const std::string& name) {
    if (!isThere(folder, name))
        return unknown(folder, name);
    std::ifstream in(fileOf(folder, name));
    std::ostringstream text;
    text << in.rdbuf();
    try {
        const Json json = Json::parse(text.str());
        return moldSettingsFrom(json.at("mold"), settings);
    } catch (const Json::exception&) {
        return failure(ErrorCode::BadInput,
                       MW_TEXT("Presets", "The preset {0} cannot be understood. Save it anew, or remove it."),
                       {fileOf(folder, name).string()});
    }
}

Result<void> savePreset(const fs::path& folder, const std::string& name, const MoldSettings& settings) {
    if (!canBeAName(name))
        return failure(ErrorCode::Usage,
                       MW_TEXT("Presets", "A preset cannot be called “{0}”. Take up to 60 letters, digits, "
                                          "spaces, hyphens or dots between."),
                       {name});
    Json mold = moldSettingsJson(settings);
    for (const char* ofOnePart : {"shrink", "density", "material", "placed"})
        mold.erase(ofOnePart);
    const Json whole = {{"version", 1}, {"mold", std::move(mold)}};
    if (Result<void> done = makeFolder(folder); !done)
        return done;
    return writeFileAtomically(fileOf(folder, name), whole.dump(2) + "\n");
}

Result<void> removePreset(const fs::path& folder, const std::string& name) {
    if (!isThere(folder, name))
        return unknown(folder, name);
    std::error_code error;
    if (!fs::remove(fileOf(folder, name), error))
        return failure(ErrorCode::WriteFailed, MW_TEXT("Presets", "{0} could not be removed: {1}."),
                       {fileOf(folder, name).string(), error.message()});
    return {};
}

bool presetHolds(const MoldSettings& settings, const fs::path& folder, const std::string& name) {
    const Result<MoldSettings> taken = withPreset(settings, folder, name);
    return taken && *taken == settings;
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/tray_parts.h"

#include "project/further_parts.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <filesystem>

namespace moldwright::cli {

namespace {

struct GivenPart {
    std::string path;
    int count = 1;
};

/// What ends in a colon and a number is a path and a count, unless there is a file of that name.
GivenPart given(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos || std::filesystem::exists(text))
        return {text};
    GivenPart part{text.substr(0, colon)};
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data() + colon + 1, end, part.count);
    return read.ec == std::errc() && read.ptr == end ? part : GivenPart{text};
}

} // namespace

void addTrayOption(CLI::App& app, std::vector<std::string>& parts) {
    app.add_option("--with", parts,
                   "Another part in the same mold, and how many of it: a project file or folder written by "
                   "design; may be given again")
        ->type_name("FILE|DIR[:N]")
        ->allow_extra_args(false);
}

Result<Tray> withParts(Tray tray, const std::vector<std::string>& parts) {
    for (const std::string& text : parts) {
        const GivenPart part = given(text);
        Result<TrayPart> read = readTrayPart(part.path, namesTaken(tray));
        if (!read)
            return failure(read.error().code, MW_TEXT("cli", "--with {0}: {1}"),
                           {part.path, read.error().english()});
        read->count = part.count;
        tray.push_back(*std::move(read));
    }
    return tray;
}

std::string partsInWords(const std::vector<PartOfMold>& parts) {
    std::string words;
    for (const PartOfMold& part : parts)
        words += (words.empty() ? "" : ", ") + std::to_string(part.cavities) + " × " + part.name;
    return words;
}

} // namespace moldwright::cli

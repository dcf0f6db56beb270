// SPDX-License-Identifier: AGPL-3.0-or-later
#include "support/folders.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace moldwright::test {

namespace {

std::optional<std::filesystem::path> folderFromEnvironment(const char* variable) {
    const char* value = std::getenv(variable); // NOLINT(concurrency-mt-unsafe)
    if (!value || !std::filesystem::is_directory(value))
        return std::nullopt;
    return value;
}

} // namespace

std::optional<std::filesystem::path> models() {
    return folderFromEnvironment("MOLDWRIGHT_MODELS");
}
std::optional<std::filesystem::path> badModels() {
    return folderFromEnvironment("MOLDWRIGHT_BAD_MODELS");
}
std::filesystem::path sourceFolder() {
    return MOLDWRIGHT_SOURCE_DIR;
}
std::filesystem::path samples() {
    return sourceFolder() / "resources" / "samples";
}
std::filesystem::path programs() {
    return MOLDWRIGHT_BIN_DIR;
}

ScratchFolder::ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "moldwright-XXXXXX").string();
    if (!mkdtemp(pattern.data()))
        throw std::runtime_error("no scratch folder at " + pattern);
    m_path = pattern;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
}

} // namespace moldwright::test

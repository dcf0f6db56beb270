// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace moldwright::test {

/// Folder of real models (environment MOLDWRIGHT_MODELS), of defective ones (MOLDWRIGHT_BAD_MODELS); none
/// when unset. A test that needs them and finds none ends with GTEST_SKIP().
std::optional<std::filesystem::path> models();
std::optional<std::filesystem::path> badModels();

/// The project's top folder, the bundled samples, and where the built programs lie.
std::filesystem::path sourceFolder();
std::filesystem::path samples();
std::filesystem::path programs();

/// A fresh empty folder under the system's temporary folder, removed with its contents when this goes.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

} // namespace moldwright::test

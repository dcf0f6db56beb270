// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "project/project.h"

#include <filesystem>
#include <string>

namespace moldwright {

/// What a .moldwright file holds: the project, and beside it what is not part of the model.
struct StoredProject {
    Project project;
    std::string viewState; ///< JSON of the window (cameras, what is shown); may be empty
    std::string thumbnail; ///< PNG; may be empty
};

/// Version of the format that is written, and the oldest reader that understands it. A newer file that an
/// older program can still read keeps minReader; each version has a golden file among the tests.
constexpr int projectFileVersion = 1;
constexpr int projectFileMinReader = 1;

/// The bytes of a project file: a zip with `mimetype` first and stored, `manifest.json` (version, minReader,
/// name, counts), `document.json` (settings), binary little-endian parts, `view.json`, `thumbnail.png`. Equal
/// projects give equal bytes: nothing in it tells when or where it was saved.
[[nodiscard]] Result<std::string> projectBytes(const StoredProject& stored);

/// Reads bytes of a project file, in memory, by known names, within limits. Errors: BadInput with a sentence
/// that names `fileName` and the damaged part, or the version that is needed.
[[nodiscard]] Result<StoredProject> readProjectBytes(const std::string& bytes, const std::string& fileName);

/// Writes atomically: an old file stays whole when anything fails. Errors: WriteFailed.
[[nodiscard]] Result<void> saveProject(const std::filesystem::path& file, const StoredProject& stored);

/// Errors: BadInput (missing, not a project, damaged, too new).
[[nodiscard]] Result<StoredProject> openProject(const std::filesystem::path& file);

/// The project of a file, or of a folder that `design` wrote, the wanted variant as the current one; an empty
/// name: as it was saved. Errors: as openProject(); Usage for a variant that there is not.
[[nodiscard]] Result<Project> projectAt(const std::filesystem::path& input, const std::string& variant);

/// manifest.json of a project file, as text. Errors as openProject().
[[nodiscard]] Result<std::string> projectManifest(const std::filesystem::path& file);

} // namespace moldwright

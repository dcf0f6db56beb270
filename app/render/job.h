// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "castability/mold_state.h"

#include <filesystem>
#include <string>

namespace moldwright::render {

/// One order to the program, as JSON: {"task": "report" | "pictures" | "thumbnail", "project": FILE,
/// "out": FILE or folder, "width": 320, "height": 240}; or {"task": "draft", "mesh": FILE, "plane": [nx, ny,
/// nz, offset], "d1": [x, y, z], "d2": [x, y, z], "draft": 1, "out": FILE, "width": 320, "height": 240}.
struct Job {
    enum class Task { Report, Pictures, Thumbnail, Draft };
    Task task = Task::Report;
    std::filesystem::path source; ///< a project; for Draft a mesh
    std::filesystem::path out;
    int width = 320; ///< of a thumbnail or a draft map, pixels
    int height = 240;
    MoldState state{}; ///< of a draft map
    double draftDegrees = 1;
};

/// Errors: Usage when the text is no job.
[[nodiscard]] Result<Job> readJob(const std::string& json);

/// The text of a job for a project: what a program that orders one writes.
[[nodiscard]] std::string jobText(const Job& job);

} // namespace moldwright::render

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"

#include <filesystem>
#include <string>

namespace moldwright::render {

/// One order to the program, as JSON: {"task": "report" | "pictures" | "thumbnail", "project": FILE,
/// "out": FILE or folder, "width": 320, "height": 240}.
struct Job {
    enum class Task { Report, Pictures, Thumbnail };
    Task task = Task::Report;
    std::filesystem::path project;
    std::filesystem::path out;
    int width = 320; ///< of a thumbnail, pixels
    int height = 240;
};

/// Errors: Usage when the text is no job.
[[nodiscard]] Result<Job> readJob(const std::string& json);

/// The text of a job: what a program that orders one writes.
[[nodiscard]] std::string jobText(const Job& job);

} // namespace moldwright::render

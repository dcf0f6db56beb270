// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "base/task.h"

#include <filesystem>
#include <string>

namespace moldwright::cli {

/// What moldwright-render answered.
struct RenderedReport {
    int pages = 0;
    std::string missingPictures; ///< why pictures are missing; empty when none is
};

/// Has moldwright-render (environment MOLDWRIGHT_RENDER, else beside this program) write the report of a
/// project file as PDF, of the variant of this name or, where it is empty, of the current one. It is a
/// program of its own: this one needs no graphics, and a fault there is a value here. Errors: Worker,
/// Cancelled, BadInput, WriteFailed.
[[nodiscard]] Result<RenderedReport> renderReport(const std::filesystem::path& project,
                                                  const std::string& variant,
                                                  const std::filesystem::path& pdf, const Task& task);

} // namespace moldwright::cli

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

/// What a report is to be of, and in which language.
struct ReportOrder {
    std::filesystem::path project;
    std::filesystem::path pdf;
    std::string variant{};  ///< empty: the current one
    std::string language{}; ///< as "de"; empty: English
};

/// Has moldwright-render (environment MOLDWRIGHT_RENDER, else beside this program) write a report as PDF. It
/// is a program of its own: this one needs no graphics, and a fault there is a value here. Errors: Worker,
/// Cancelled, BadInput, WriteFailed.
[[nodiscard]] Result<RenderedReport> renderReport(const ReportOrder& order, const Task& task);

} // namespace moldwright::cli

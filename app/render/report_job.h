// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "render/job.h"

#include <string>
#include <vector>

namespace moldwright::render {

struct ReportAnswer {
    int pages = 0;
    std::string missingPictures; ///< why pictures are missing; empty when none is
};

/// Writes the report of a project. Its pictures are drawn by another process of this program, so that a fault
/// in the graphics stack costs the pictures and not the report. Needs a QGuiApplication. Errors: BadInput,
/// WriteFailed.
[[nodiscard]] Result<ReportAnswer> writeReport(const Job& job);

} // namespace moldwright::render

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "report/report_data.h"

#include <filesystem>

namespace moldwright::render {

/// Writes the report as a PDF of A4 pages; returns their count. `pictures` holds the files of pictures.h; one
/// that is missing leaves its place with a note. The file appears whole or not at all. Errors: WriteFailed.
[[nodiscard]] Result<int> writeReportPdf(const ReportData& data, const std::filesystem::path& pictures,
                                         const std::filesystem::path& file);

} // namespace moldwright::render

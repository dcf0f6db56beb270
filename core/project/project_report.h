// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/pipeline.h"
#include "report/report_data.h"

#include <string>

namespace moldwright {

/// The report of an evaluated project, in the language of the phrases. `fileHash` names the project file,
/// `date` is printed as it is.
[[nodiscard]] ReportData projectReport(const Project& project, const Evaluation& evaluation,
                                       const std::string& fileHash, const std::string& date,
                                       const Phrases& say = {});

/// Today as reports print it, "22 November 2026"; the day of SOURCE_DATE_EPOCH (UTC) when that is set.
[[nodiscard]] std::string reportDate(const Phrases& say = {});

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "report/report_data.h"

#include <optional>
#include <string>
#include <vector>

namespace moldwright {

/// What was built into a mold besides its cavities: a row for each name, cavities of different parts apart,
/// with how many there are and their sizes, in mm, degrees, cm³ or mm³; from the least to the greatest where
/// they differ. None where the mold has cavities of one part only.
[[nodiscard]] std::optional<ReportTable> featureTable(const Mold& mold, const Phrases& say);

/// What is proved of a mold but should be known: the builder's notes, those of single features once each.
[[nodiscard]] std::vector<std::string> notesOf(const Mold& mold, const Phrases& say);

} // namespace moldwright

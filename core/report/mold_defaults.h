// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/mold_settings.h"
#include "report/phrases.h"

#include <string>
#include <vector>

namespace moldwright {

/// A value that nobody chose, with where it comes from.
struct ReportDefault {
    std::string name;
    std::string value;
    std::string source;
};

/// Of the block and the process: what stands as it comes.
[[nodiscard]] std::vector<ReportDefault> blockDefaults(const MoldSettings& settings, const Phrases& say);

/// What was taken of the material that was chosen, with each value's source and what to beware of.
[[nodiscard]] std::vector<ReportDefault> materialValues(const MoldSettings& settings, const Phrases& say);

/// Of the features that a mold with these settings has: what stands as it comes.
[[nodiscard]] std::vector<ReportDefault> featureDefaults(const MoldSettings& settings, const Phrases& say);

} // namespace moldwright

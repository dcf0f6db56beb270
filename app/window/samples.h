// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "panels/start_page.h"

#include <vector>

namespace moldwright {

/// The parts bundled with the program, in the order of the start page; empty when they are not installed.
[[nodiscard]] std::vector<SampleCard> bundledSamples();

} // namespace moldwright

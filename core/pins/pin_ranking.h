// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "pins/suggested_pins.h"

namespace moldwright {

/// Ranks pins by what they are, how much surface is theirs and what they gain.
void setRanks(std::vector<SuggestedPin>& pins);

} // namespace moldwright

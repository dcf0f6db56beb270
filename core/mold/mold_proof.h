// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/mold.h"

#include <string>
#include <vector>

namespace moldwright {

/// What of a built mold does not hold, in English; empty when all is proved: the cast's certificate, both
/// halves as they are written (one closed solid each, free to move along its direction by angles and by
/// rays), with keys both opened at once too, and that the volumes add up to the block's.
[[nodiscard]] std::vector<std::string> problemsOf(const Mold& mold);

} // namespace moldwright

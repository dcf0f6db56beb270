// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/block.h"
#include "mold/mold.h"

namespace moldwright {

/// Certifies a built mold's cast, and notes what of the mold does not hold, in English; nothing when all is
/// proved: the cast's certificate, both halves as they are written (one closed solid each, free to move along
/// its direction by angles and by rays), with keys both opened at once too, drafted outer faces against
/// their form, sprues pushed out of half 1, and that the volumes add up to the block's.
void proveMold(Mold& mold, const Block& block);

} // namespace moldwright

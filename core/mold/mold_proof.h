// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/mold.h"

namespace moldwright {

/// Certifies a built mold's cast, and notes what of the mold does not hold, in English; nothing when all is
/// proved: the cast's certificate, both halves as they are written (one closed solid each, free to move along
/// its direction by angles and by rays), with keys both opened at once too, and that the volumes add up to
/// the block's.
void proveMold(Mold& mold);

} // namespace moldwright

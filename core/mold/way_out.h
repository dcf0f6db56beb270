// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/contact_ways.h"
#include "mold/mold.h"

#include <array>

namespace moldwright {

/// Where halves 1 and 2 of a mold, as meshes, meet the cast in its first cavity while they leave along its
/// directions. `cast`: in the part's frame, as it was given to buildMold(). Nothing where the mold is proved.
[[nodiscard]] std::array<ContactWays, 2> contactsOnTheWayOut(const Mold& mold, const IndexedMesh& cast);

} // namespace moldwright

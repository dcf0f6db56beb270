// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "deformation/clean_up.h"

namespace moldwright {

/// Frees the faces below τ that neither motion nor cleanUp() can mend: a crack in the parting line, a tent
/// over a fold, where every single change makes matters worse; and those that are folded in the plane. Tries
/// each collapse that the parting line allows about such a face, lets cleanUp()'s changes follow it, and
/// keeps the sequence that leaves the fewest such faces, if they are fewer. It tries on a copy of the faces
/// about it, so its time grows with the number of such faces alone. Returns the number of changes.
int dislodge(LabelledSurface& surface, const CleanUpGoal& goal);

} // namespace moldwright

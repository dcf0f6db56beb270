// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/clean_up.h"

#include "deformation/surgery.h"

namespace moldwright {

int cleanUp(LabelledSurface& surface, const CleanUpGoal& goal) {
    Surgery surgery(LabelledMesh(surface), goal);
    surgery.mend([&] { return surgery.allFaces(); });
    if (!surgery.steps().empty())
        surface = surgery.mesh().surface();
    return static_cast<int>(surgery.steps().size());
}

} // namespace moldwright

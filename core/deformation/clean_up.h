// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "deformation/labelled_mesh.h"

namespace moldwright {

/// What the clean-up is to achieve.
struct CleanUpGoal {
    Directions directions;
    double tau = 0;              ///< faces below it are mended where that makes them better
    double shortestEdge = 0;     ///< shorter edges are collapsed where nothing gets worse
    double smallestAltitude = 0; ///< so are the needles and caps below this height
};

/// Mends the faces that a smooth motion cannot mend, by flips and collapses of their edges (OpenMesh), or
/// where neither helps by moving one of their points to its best place. A change is made only where the worst
/// draft of the faces around it rises, or fewer of them miss it and it does not fall, or, for the short and
/// the thin, where it does not fall below τ or where it was. The parting line stays simple: no collapse
/// sweeps it over one of its points, leaves a loop of three, lays a face into the plane, or flips an edge
/// between labels. Where points are removed others take their places; sourceVertex follows. Returns the
/// number of changes made.
int cleanUp(LabelledSurface& surface, const CleanUpGoal& goal);

} // namespace moldwright

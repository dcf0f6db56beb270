// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "castability/direction_limits.h"
#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

/// What a search for parting planes may do.
struct PlaneSearch {
    int count = 6;      ///< K distinct planes asked for
    int samples = 1000; ///< random planes tried before local refinement
    double draftDegrees = 1;
    DirectionLimits limits;        ///< only planes that allow directions are looked at
    bool normalDirections = false; ///< keep d1 = n, d2 = −n
    unsigned seed = 1;
};

/// A parting plane with its directions and how good it is.
struct PlaneCandidate {
    MoldState state;
    double energy = 0; ///< Eq. (2), scale-free
    double violatingAreaFraction = 0;
    double worstDraftDegrees = 0;
    double smallerVolumeFraction = 0; ///< share of the volume on the smaller side, 0 for a flat-backed part
};

/// The best distinct parting planes of a closed mesh, best first: random sampling and local refinement of
/// plane and directions by L-BFGS on Eq. (2), both on a coarse copy; then ranked on the mesh itself. Flat
/// backs are always among those looked at, where the limits allow directions there. [Stein 2019],
/// Section 6.3. Deterministic for a given seed.
[[nodiscard]] std::vector<PlaneCandidate> findPlanes(const IndexedMesh& mesh, const PlaneSearch& search,
                                                     const Task& task = {});

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <Eigen/Geometry>

namespace moldwright {

/// A cast in the mold's frame: parting plane z = 0, side 1 up, the block's centre over the origin, every
/// coordinate a float, points of the parting plane at z = 0 exactly.
struct PlacedCast {
    IndexedMesh mesh;
    MoldState state;            ///< plane z = 0; directions unit
    Eigen::Isometry3d fromPart; ///< part's frame to mold's frame
};

/// Moves the cast into the mold's frame, turned about the plane's normal so that the box round it is small.
/// Faces keep their draft through the rounding where floats allow it (roundKeepingDraft()); with a `grid` the
/// coordinates are multiples of it.
[[nodiscard]] PlacedCast placeCast(const IndexedMesh& cast, const SideLabels& labels, const MoldState& state,
                                   double draftDegrees, double grid = 0);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "castability/parting_curves.h"
#include "mesh/indexed_mesh.h"
#include "mold/block.h"

#include <optional>
#include <vector>

namespace moldwright {

/// The flat faces in which the halves meet: the block's rectangle less what the parting curves enclose.
struct PartingFace {
    std::vector<int> castPoints; ///< points of the parting curves, as indices into the cast
    Triangles faces; ///< seen from side 1 counter-clockwise; indices into castPoints, then the four corners
};

/// Triangulates the parting face between the block's outline and the curves. Inside an even number of curves
/// there is steel: the middle of a ring belongs to it. None when the curves cross.
[[nodiscard]] std::optional<PartingFace>
partingFace(const IndexedMesh& placedCast, const std::vector<PartingCurve>& curves, const Block& block);

/// Mold half `side`: a graph over the plane, so no boolean operation is needed. The cast's faces of that
/// label turned inside out, the parting face, and the block's walls and top. Both halves use the same points
/// of the plane, so they meet exactly.
[[nodiscard]] IndexedMesh assembleHalf(int side, const IndexedMesh& placedCast, const SideLabels& labels,
                                       const PartingFace& parting, const Block& block);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/parting.h"

#include <limits>
#include <vector>

namespace moldwright {

/// How much is filled: what the designer chose; what the topological certificate asks for too, the rest being
/// left to bending; all that cannot leave.
enum class FillExtent { Chosen, Needed, All };

/// What is filled of a part before it is bent. A choice counts more than the extent.
struct Filling {
    FillExtent extent = FillExtent::Needed;
    std::vector<UndercutChoice> choices;
};

/// Whether any of them is to be filled; whether any is to be bent.
[[nodiscard]] bool fillsAny(const std::vector<UndercutChoice>& choices);
[[nodiscard]] bool bendsAny(const std::vector<UndercutChoice>& choices);

/// Parts the part and fills it (see fill_plan.h); the new walls stand along the directions and still want
/// leaning. surface.sourceFace is −1 on them. Pins that filling buries lie inside. Errors: Impossible where
/// an undercut that no bending frees was chosen to be bent; Internal, Cancelled; of the solid, Worker too.
[[nodiscard]] Result<PartedPart> filledSurface(const IndexedMesh& part, const MoldState& state,
                                               const Filling& filling, const Task& task,
                                               const std::vector<PlacedPin>& pins = {});
[[nodiscard]] Result<PartedSolid> filledSolid(const IndexedMesh& part, const MoldState& state,
                                              const Filling& filling, const Task& task,
                                              const std::vector<PlacedPin>& pins = {});

/// The part with all filled that cannot leave, the walls leaning by the draft already (see fillWithDraft()):
/// nothing is left to bend. Errors: Internal, Cancelled.
[[nodiscard]] Result<PartedPart> filledWithDraft(const IndexedMesh& part, const MoldState& state,
                                                 double draftDegrees, const Task& task,
                                                 const std::vector<PlacedPin>& pins = {});

/// planePasses() and obstructionsAt() for the part with the undercuts filled that were chosen to be.
[[nodiscard]] bool planePasses(const IndexedMesh& part, const MoldState& state,
                               const std::vector<UndercutChoice>& choices, const Task& task);
[[nodiscard]] ObstructedPart obstructionsAt(const IndexedMesh& part, const MoldState& state,
                                            const std::vector<UndercutChoice>& choices, const Task& task);

/// An undercut of a part that can be filled on its own. Part frame, mm.
struct FillableUndercut {
    int side = 0;           ///< 1 or 2; 0: it reaches through the plane
    Eigen::Vector3d place;  ///< on the part's surface
    double size = 0;        ///< diagonal of its box
    double volume = 0;      ///< mm³ that filling takes
    bool needed = false;    ///< no bending frees it
    bool joins = false;     ///< filling it makes one of pieces that are apart
    std::vector<int> faces; ///< of the part, that vanish
    IndexedMesh walls;      ///< what filling makes in their place, without draft yet
};

/// All undercuts of the part at `state`, the largest first. Errors: Internal, Cancelled.
[[nodiscard]] Result<std::vector<FillableUndercut>>
fillableUndercuts(const IndexedMesh& part, const MoldState& state, const Task& task);

/// The undercut whose faces come nearest to a place, by their corners; −1 where none is within `reach`, mm.
[[nodiscard]] int undercutNearest(const std::vector<FillableUndercut>& undercuts, const IndexedMesh& part,
                                  const Eigen::Vector3d& place,
                                  double reach = std::numeric_limits<double>::infinity());

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "castability/mold_state.h"
#include "features/drafted_prism.h"
#include "mold/block.h"
#include "mold/free_place.h"
#include "mold/mold_settings.h"

#include <vector>

namespace moldwright {

/// A pocket in the parting face, in which a nut, a magnet, a dowel or another insert is laid.
struct InsertPocket {
    Eigen::Vector2d place = Eigen::Vector2d::Zero(); ///< its middle, mm
    DraftedPrism prism;
};

/// The area in the parting plane that a pocket takes. Its walls lean by half a degree more than the draft.
[[nodiscard]] PlanShape pocketRoom(const PocketSettings& pockets, const Eigen::Vector2d& place,
                                   const Directions& directions, double draftDegrees);

/// Places for `wishes.size()` pockets: those by hand, the others round the block as bolts are, but beginning
/// with the middles of its sides. Fewer where there is no room: then the block must grow.
[[nodiscard]] std::vector<Eigen::Vector2d> pocketPlaces(const PocketSettings& pockets,
                                                        const Directions& directions, double draftDegrees,
                                                        const Block& block, const Obstacles& obstacles,
                                                        double steel, const Wishes& wishes, Pull pull);

/// The pocket at a place: at its floor the insert has room with its clearance, at the plane it is wider by
/// the draft, so that the half's own form or cutter leaves it. Errors: Impossible.
[[nodiscard]] Result<InsertPocket> insertPocket(const PocketSettings& pockets, const Eigen::Vector2d& place,
                                                const Directions& directions, double draftDegrees,
                                                double grid);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "mold/free_place.h"
#include "mold/mold_settings.h"

namespace moldwright {

/// Places for `wishes.size()` bolts: those by hand, the others as near to the block's corners, then to the
/// middles of its sides, as their walls allow. Fewer where there is no room: then the block must grow.
/// Obstacles hold what stands there by hand.
[[nodiscard]] std::vector<Eigen::Vector2d> boltPlaces(const BoltSettings& bolts, const Block& block,
                                                      const Obstacles& obstacles, const Wishes& wishes,
                                                      Pull pull);

/// The area that a hole takes, seen along the normal, and `about` mm about it.
[[nodiscard]] PlanShape boltRoom(const BoltSettings& bolts, const Eigen::Vector2d& place, double about = 0);

/// The outline of a hole: corners on the grid, round a circle of the bolt's diameter.
[[nodiscard]] PlanShape boltOutline(const BoltSettings& bolts, const Eigen::Vector2d& place, double grid);

/// A straight tube over the outline from the parting plane to the block's face at z = `end`, looking
/// outwards and open at both. A bolt is drawn out before the mold is opened: it needs no draft, whatever the
/// removal directions.
[[nodiscard]] IndexedMesh boltSurface(const PlanShape& outline, double end);

/// The hole through both halves, closed.
[[nodiscard]] IndexedMesh boltSolid(const PlanShape& outline, const Block& block);

} // namespace moldwright

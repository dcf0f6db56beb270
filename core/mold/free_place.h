// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "features/plan_shape.h"
#include "mold/block.h"

#include <optional>
#include <vector>

namespace moldwright {

/// What stands in the parting plane already.
using Obstacles = std::vector<PlanShape>;

/// Whether a shape keeps `steel` mm from all obstacles.
[[nodiscard]] bool keepsClear(const PlanShape& shape, const Obstacles& obstacles, double steel);

/// Steel that a round feature keeps, mm.
struct Clearances {
    double outside = 0; ///< to the block's faces
    double inside = 0;  ///< to everything that stands in the plane
};

/// Where features round the block are best.
enum class Pull {
    Outwards, ///< as near to their place at the block's edge as there is room
    Inwards   ///< as far from there as there is room: the block is cut down to them
};

/// The free place for a circle that is nearest to `wish`, or farthest from it, in the part of the block that
/// is nearer to it than to its middle; none where there is no room.
[[nodiscard]] std::optional<Eigen::Vector2d> nearestFree(const Eigen::Vector2d& wish, double radius,
                                                         const Block& block, const Obstacles& obstacles,
                                                         const Clearances& steel, Pull pull = Pull::Outwards);

/// Where features of one kind were put by hand, in their order; none: it finds its own place.
using Wishes = std::vector<std::optional<Eigen::Vector2d>>;

/// The wishes for `count` features of a kind.
[[nodiscard]] Wishes wishesFor(const PlacedFeatures& placed, Placeable kind, int count);

/// Where features round the block are wanted: its corners, alternately opposite, then the middles of its
/// sides, then halfway between these; `mostRound` at most.
inline constexpr int mostRound = 16;
[[nodiscard]] std::vector<Eigen::Vector2d> placesRound(const Block& block, int count);

/// Corners of the polygons that stand for circles in the plane.
constexpr int circleCorners = 32;

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/pockets.h"

#include "features/wall_slope.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace moldwright {

namespace {

using Eigen::Vector2d;

constexpr double leanMargin = 0.5; // degrees

/// Round the insert as it is seen along the normal, `wider` mm from it.
PlanShape outlineRound(const PocketSettings& pockets, const Vector2d& place, double wider) {
    if (pockets.shape == PocketShape::Rectangle) {
        const Vector2d half = Vector2d(pockets.length, pockets.width) / 2 + Vector2d::Constant(wider);
        return planRectangle(place - half, place + half);
    }
    // A polygon whose sides touch the circle.
    const int corners = pockets.shape == PocketShape::Hexagon ? 6 : circleCorners;
    return planCircle(place, (pockets.width / 2 + wider) / std::cos(std::numbers::pi / corners), corners);
}

/// The most that one of its walls leans over its depth, mm; 0 where a wall would have to lie flat.
double widening(const PocketSettings& pockets, const Directions& directions, double draftDegrees) {
    double most = 0;
    for (const int side : {1, 2})
        for (int k = 0; k < circleCorners && pockets.isIn(side); ++k) {
            const double angle = 2 * std::numbers::pi * k / circleCorners;
            const std::optional<double> slope = wallSlope({std::cos(angle), std::sin(angle)}, side,
                                                          {directions.of(side)}, draftDegrees + leanMargin);
            most = std::max(most, slope.value_or(0) * pockets.depth);
        }
    return most;
}

} // namespace

PlanShape pocketRoom(const PocketSettings& pockets, const Vector2d& place, const Directions& directions,
                     double draftDegrees) {
    return outlineRound(pockets, place, pockets.clearance + widening(pockets, directions, draftDegrees));
}

std::vector<Vector2d> pocketPlaces(const PocketSettings& pockets, const Directions& directions,
                                   double draftDegrees, const Block& block, const Obstacles& obstacles,
                                   double steel, const Wishes& wishes, Pull pull) {
    constexpr std::size_t corners = 4;
    std::vector<Vector2d> round =
        placesRound(block, std::min(mostRound, static_cast<int>(corners + wishes.size())));
    std::rotate(round.begin(), round.begin() + corners, round.end());
    double radius = 0;
    for (const Vector2d& p : pocketRoom(pockets, {0, 0}, directions, draftDegrees))
        radius = std::max(radius, p.norm());
    std::vector<Vector2d> places;
    Obstacles taken = obstacles;
    for (std::size_t i = 0; i < std::min(round.size(), wishes.size()); ++i) {
        const std::optional<Vector2d> place =
            wishes[i] ? wishes[i] : nearestFree(round[i], radius, block, taken, {steel, steel}, pull);
        if (!place)
            break;
        places.push_back(*place);
        taken.push_back(pocketRoom(pockets, *place, directions, draftDegrees));
    }
    return places;
}

Result<InsertPocket> insertPocket(const PocketSettings& pockets, const Vector2d& place,
                                  const Directions& directions, double draftDegrees, double grid) {
    PrismRequest request;
    request.base = pocketRoom(pockets, place, directions, draftDegrees);
    for (const int side : {1, 2})
        request.height[side == 1 ? 0 : 1] = pockets.isIn(side) ? pockets.depth : 0;
    request.directions = {std::vector{directions.d1}, std::vector{directions.d2}};
    request.draftDegrees = draftDegrees + leanMargin;
    request.leastSlope = 0;
    request.grid = grid;
    Result<DraftedPrism> prism = draftedPrism(request);
    if (!prism)
        return std::unexpected(prism.error());
    return InsertPocket{place, *std::move(prism)};
}

} // namespace moldwright

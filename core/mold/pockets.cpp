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

/// The floor: round the insert as it is seen along the normal, with its clearance.
PlanShape floorOf(const PocketSettings& pockets, const Vector2d& place) {
    const double wider = pockets.clearance;
    if (pockets.shape == PocketShape::Rectangle) {
        const Vector2d half = Vector2d(pockets.length, pockets.width) / 2 + Vector2d::Constant(wider);
        return planRectangle(place - half, place + half);
    }
    // A polygon whose sides touch the circle.
    const int corners = pockets.shape == PocketShape::Hexagon ? 6 : circleCorners;
    return planCircle(place, (pockets.width / 2 + wider) / std::cos(std::numbers::pi / corners), corners);
}

/// How far each wall leans, inset over depth: no wall overhangs, for the insert is laid in along the normal.
/// The same in both halves, so that both floors fit. None where a wall would have to lie flat.
std::optional<std::vector<double>> leanOfWalls(const PocketSettings& pockets, const PlanShape& floor,
                                               const Directions& directions, double draftDegrees) {
    std::vector<double> lean(floor.size(), 0);
    for (const int side : {1, 2})
        for (std::size_t edge = 0; edge < floor.size() && pockets.isIn(side); ++edge) {
            const std::optional<double> slope =
                wallSlope(outwardNormal(floor, edge), side, {directions.of(side)}, draftDegrees + leanMargin);
            if (!slope)
                return std::nullopt;
            lean[edge] = std::max(lean[edge], *slope);
        }
    return lean;
}

/// The opening in the parting plane over a floor.
PlanShape mouthOf(const PlanShape& floor, std::vector<double> lean, double depth) {
    for (double& inset : lean)
        inset *= -depth;
    return insetShape(floor, lean);
}

} // namespace

PlanShape pocketRoom(const PocketSettings& pockets, const Vector2d& place, const Directions& directions,
                     double draftDegrees) {
    const PlanShape floor = floorOf(pockets, place);
    return mouthOf(
        floor,
        leanOfWalls(pockets, floor, directions, draftDegrees).value_or(std::vector<double>(floor.size(), 0)),
        pockets.depth);
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
    const PlanShape floor = floorOf(pockets, place);
    const auto lean = leanOfWalls(pockets, floor, directions, draftDegrees);
    if (!lean)
        return failure(ErrorCode::Impossible,
                       MW_TEXT("Mold", "A pocket's wall would have to lie flat to leave along the removal "
                                       "directions with {0}°."),
                       {readable(draftDegrees + leanMargin)});
    PrismRequest request;
    request.base = mouthOf(floor, *lean, pockets.depth);
    for (const int side : {1, 2}) {
        request.height[side == 1 ? 0 : 1] = pockets.isIn(side) ? pockets.depth : 0;
        request.slopes[side == 1 ? 0 : 1] = *lean;
    }
    request.grid = grid;
    Result<DraftedPrism> prism = draftedPrism(request);
    if (!prism)
        return std::unexpected(prism.error());
    return InsertPocket{place, *std::move(prism)};
}

} // namespace moldwright

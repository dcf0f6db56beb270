// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/free_place.h"

#include <algorithm>

namespace moldwright {

using Eigen::Vector2d;

bool keepsClear(const PlanShape& shape, const Obstacles& obstacles, double steel) {
    return std::all_of(obstacles.begin(), obstacles.end(),
                       [&](const PlanShape& obstacle) { return planKeepsClear(shape, obstacle, steel); });
}

std::optional<Vector2d> nearestFree(const Vector2d& wish, double radius, const Block& block,
                                    const Obstacles& obstacles, const Clearances& steel, Pull pull) {
    constexpr double searchStep = 1; // mm
    const double edge = radius + steel.outside;
    const Eigen::AlignedBox2d box = block.plan();
    const Vector2d low = box.min().array() + edge;
    const Vector2d high = box.max().array() - edge;
    std::vector<Vector2d> candidates;
    const Vector2d start = wish.cwiseMax(low).cwiseMin(high);
    const Vector2d middle = box.center();
    for (double x = low.x(); x <= high.x(); x += searchStep)
        for (double y = low.y(); y <= high.y(); y += searchStep)
            if ((Vector2d(x, y) - start).norm() < (start - middle).norm() / 2)
                candidates.emplace_back(x, y);
    candidates.push_back(start);
    std::stable_sort(candidates.begin(), candidates.end(), [&](const Vector2d& a, const Vector2d& b) {
        if (pull == Pull::Inwards) // least far out along the way to the wish
            return (a - middle).dot(start - middle) < (b - middle).dot(start - middle);
        return (a - start).squaredNorm() < (b - start).squaredNorm();
    });
    for (const Vector2d& place : candidates)
        if (block.depthOf(place) >= edge - 1e-9 &&
            keepsClear(planCircle(place, radius, circleCorners), obstacles, steel.inside))
            return place;
    return std::nullopt;
}

Wishes wishesFor(const PlacedFeatures& placed, Placeable kind, int count) {
    Wishes wishes;
    for (int number = 0; number < count; ++number)
        wishes.push_back(placeByHand(placed, kind, number));
    return wishes;
}

std::vector<Vector2d> placesRound(const Block& block, int count) {
    const Eigen::AlignedBox2d box = block.plan();
    const Vector2d low = box.min();
    const Vector2d high = box.max();
    const Vector2d middle = box.center();
    std::vector<Vector2d> places{low,
                                 high,
                                 {high.x(), low.y()},
                                 {low.x(), high.y()},
                                 {middle.x(), low.y()},
                                 {low.x(), middle.y()},
                                 {high.x(), middle.y()},
                                 {middle.x(), high.y()}};
    places.resize(static_cast<std::size_t>(std::min(count, static_cast<int>(places.size()))));
    return places;
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/free_place.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace moldwright;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// By trying all places of the search's raster from the best on, with the polygon that stands for the circle.
std::optional<Vector2d> plainly(const Vector2d& wish, double radius, const Block& block,
                                const Obstacles& obstacles, const Clearances& steel, Pull pull) {
    const double edge = radius + steel.outside;
    const Vector2d low = block.plan().min().array() + edge;
    const Vector2d high = block.plan().max().array() - edge;
    const Vector2d start = wish.cwiseMax(low).cwiseMin(high);
    const Vector2d middle = block.plan().center();
    std::vector<Vector2d> places;
    for (double x = low.x(); x <= high.x(); x += 1)
        for (double y = low.y(); y <= high.y(); y += 1)
            if ((Vector2d(x, y) - start).norm() < (start - middle).norm() / 2)
                places.emplace_back(x, y);
    places.push_back(start);
    std::stable_sort(places.begin(), places.end(), [&](const Vector2d& a, const Vector2d& b) {
        if (pull == Pull::Inwards)
            return (a - middle).dot(start - middle) < (b - middle).dot(start - middle);
        return (a - start).squaredNorm() < (b - start).squaredNorm();
    });
    for (const Vector2d& place : places)
        if (block.depthOf(place) >= edge - 1e-9 &&
            keepsClear(planCircle(place, radius, circleCorners), obstacles, steel.inside))
            return place;
    return std::nullopt;
}

} // namespace

TEST(FreePlace, IsTheBestOfAll) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> at(-45, 45);
    std::uniform_real_distribution<double> size(2, 14);
    const Block block = uprightBlock({Vector3d(-50, -40, -10), Vector3d(50, 40, 10)});
    int found = 0;
    constexpr int rounds = 100;
    for (int round = 0; round < rounds; ++round) {
        Obstacles obstacles;
        for (int k = 0; k < 14; ++k) {
            const Vector2d place(at(random), at(random));
            obstacles.push_back(k % 3 == 0
                                    ? planRectangle(place, place + Vector2d(size(random), size(random)))
                                    : planCircle(place, size(random), k % 3 == 1 ? circleCorners : 5));
        }
        const Vector2d wish(at(random), at(random));
        const double radius = size(random) / 3;
        const Clearances steel{size(random) / 4, size(random) / 4};
        const Pull pull = round % 2 == 0 ? Pull::Outwards : Pull::Inwards;
        const std::optional<Vector2d> place = nearestFree(wish, radius, block, obstacles, steel, pull);
        EXPECT_EQ(place, plainly(wish, radius, block, obstacles, steel, pull));
        found += place ? 1 : 0;
    }
    EXPECT_GT(found, rounds / 4);
}

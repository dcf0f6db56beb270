// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/plan_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace moldwright;
using Eigen::Vector2d;

namespace {

/// A star-shaped polygon, hollow corners and all.
PlanShape ragged(std::mt19937& random, const Vector2d& middle) {
    std::uniform_real_distribution<double> reach(1, 8);
    const int corners = std::uniform_int_distribution(3, 20)(random);
    PlanShape shape;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * k / corners;
        shape.emplace_back(middle + reach(random) * Vector2d(std::cos(angle), std::sin(angle)));
    }
    return shape;
}

} // namespace

TEST(PlanShape, KeepsClearWhereTheDistanceIsEnough) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-15, 15);
    int clear = 0;
    constexpr int pairs = 4000;
    for (int i = 0; i < pairs; ++i) {
        const PlanShape a = ragged(random, {place(random), place(random)});
        const PlanShape b = ragged(random, {place(random), place(random)});
        const double asked = std::abs(place(random)) / 3;
        const bool apart = planDistance(a, b) >= asked;
        EXPECT_EQ(planKeepsClear(a, b, asked), apart);
        EXPECT_EQ(planKeepsClear(b, a, asked), apart);
        clear += apart ? 1 : 0;
    }
    EXPECT_GT(clear, pairs / 10);
    EXPECT_LT(clear, pairs * 9 / 10);
}

TEST(PlanShape, IsAsFarFromAPlaceAsFromAShapeOfOnePoint) {
    std::mt19937 random(12);
    std::uniform_real_distribution<double> place(-12, 12);
    for (int i = 0; i < 2000; ++i) {
        const PlanShape shape = ragged(random, {0, 0});
        const Vector2d p(place(random), place(random));
        EXPECT_EQ(planDistanceTo(shape, p), planDistance(PlanShape{p}, shape));
    }
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/wall_slope.h"

#include "castability/mold_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace moldwright;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// N·d of a wall with slope k.
double draftOf(const Vector2d& m, double k, int side, const Vector3d& d) {
    return Vector3d(m.x(), m.y(), side == 1 ? k : -k).normalized().dot(d);
}

} // namespace

TEST(WallSlope, AlongTheNormalIsTheDraft) {
    EXPECT_NEAR(*wallSlope({1, 0}, 1, {Vector3d::UnitZ()}, 5), std::tan(radians(5)), 1e-12);
    EXPECT_NEAR(*wallSlope({0, -1}, 2, {-Vector3d::UnitZ()}, 3), std::tan(radians(3)), 1e-12);
}

TEST(WallSlope, AcrossATiltIsTiltAndDraftOnOneSideAndLessOnTheOther) {
    const Vector3d d(std::sin(radians(20)), 0, std::cos(radians(20)));
    EXPECT_NEAR(*wallSlope({-1, 0}, 1, {d}, 5), std::tan(radians(25)), 1e-12);
    EXPECT_NEAR(*wallSlope({1, 0}, 1, {d}, 5), std::tan(radians(-15)), 1e-12);
}

TEST(WallSlope, AlongATiltIsTheFormulaOfTheChannel) {
    // φ = 90°: the wall looks across the tilt; ρ = cos β.
    const double beta = radians(25);
    const Vector3d d(std::sin(beta), 0, std::cos(beta));
    const double lean = std::asin(std::sin(radians(4)) / std::cos(beta));
    EXPECT_NEAR(*wallSlope({0, 1}, 1, {d}, 4), std::tan(lean), 1e-12);
}

TEST(WallSlope, IsTheLeastThatHoldsForAllDirections) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int trial = 0; trial < 500; ++trial) {
        const double angle = std::numbers::pi * number(random);
        const Vector2d m(std::cos(angle), std::sin(angle));
        const int side = trial % 2 + 1;
        std::vector<Vector3d> ds;
        for (int i = 0; i < 2; ++i)
            ds.push_back(
                Vector3d(0.5 * number(random), 0.5 * number(random), side == 1 ? 1 : -1).normalized());
        const std::optional<double> k = wallSlope(m, side, ds, 3);
        ASSERT_TRUE(k);
        double least = 1;
        for (const Vector3d& d : ds)
            least = std::min(least, draftOf(m, *k, side, d));
        EXPECT_NEAR(least, std::sin(radians(3)), 1e-12);
    }
}

TEST(WallSlope, IsNoneWhereThereIsNoDraftToBeHad) {
    const Vector3d d(std::sin(radians(80)), 0, std::cos(radians(80)));
    EXPECT_FALSE(wallSlope({0, 1}, 1, {d}, 15));  // sin 15° > cos 80°
    EXPECT_FALSE(wallSlope({-1, 0}, 1, {d}, 10)); // would lie flat
    EXPECT_FALSE(wallSlope({1, 0}, 1, {-Vector3d::UnitZ()}, 1));
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace moldwright::samples;

TEST(Field, ExpansionOfABallIsKnown) {
    const Vector3d p(3, 4, 12); // 13 from the centre
    const Taylor t = expand(ball({0, 0, 0}, 5), p, 1e-2);
    const Vector3d n = p / 13;
    EXPECT_NEAR(t.value, 8, 1e-12);
    EXPECT_LT((t.gradient - n).norm(), 1e-6);
    EXPECT_LT((t.hessian - (Eigen::Matrix3d::Identity() - n * n.transpose()) / 13).norm(), 1e-5);
    EXPECT_LT((gradient(ball({0, 0, 0}, 5), p) - n).norm(), 1e-8);
}

TEST(Field, EllipsoidVanishesOnItsSurfaceWithUnitSlope) {
    const Field solid = ellipsoid({1, 2, 3}, {4, 2, 1});
    for (const Vector3d& p : {Vector3d(5, 2, 3), Vector3d(1, 0, 3), Vector3d(1, 2, 4)}) {
        EXPECT_NEAR(solid(p), 0, 1e-12);
        EXPECT_NEAR(gradient(solid, p).norm(), 1, 1e-5);
    }
    EXPECT_LT(solid({1, 2, 3}), 0);
}

TEST(Field, EllipsoidTurns) {
    const Field upright = ellipsoid({0, 0, 0}, {4, 2, 1}, {0, std::numbers::pi / 2, 0});
    EXPECT_NEAR(upright({0, 0, 4}), 0, 1e-12);
    EXPECT_NEAR(upright({1, 0, 0}), 0, 1e-12);
}

TEST(Field, RoundedBoxKeepsItsFacesAndRoundsItsCorners) {
    const Field box = roundedBox({0, 0, 0}, {3, 2, 1}, 0.5);
    EXPECT_NEAR(box({3, 0, 0}), 0, 1e-12);
    EXPECT_NEAR(box({0, 0, 2}), 1, 1e-12);
    EXPECT_NEAR(box({3, 2, 1}), 0.5 * (std::sqrt(3.0) - 1), 1e-12);
}

TEST(Field, SmoothMinBlendsOnlyNearby) {
    EXPECT_EQ(smoothMin(1, 4, 2), 1);
    EXPECT_EQ(smoothMin(4, 1, 2), 1);
    EXPECT_NEAR(smoothMin(1, 1, 2), 1 - 2.0 / 6, 1e-12);
    EXPECT_EQ(smoothMin(1, 1, 0), 1);
    EXPECT_LT(smoothMin(1, 1.5, 2), 1);
}

TEST(Field, CompositionsKeepInsideAndOutside) {
    const Field left = ball({-2, 0, 0}, 3);
    const Field right = ball({2, 0, 0}, 3);
    const Vector3d onlyLeft(-4, 0, 0);
    const Vector3d both(0, 0, 0);
    EXPECT_LT(join({left, right}, 0)(onlyLeft), 0);
    EXPECT_GT(overlap(left, right, 0)(onlyLeft), 0);
    EXPECT_LT(overlap(left, right, 0)(both), 0);
    EXPECT_LT(carve(left, right, 0)(onlyLeft), 0);
    EXPECT_GT(carve(left, right, 0)(both), 0);
}

TEST(Field, MotionsCarryTheSolidAlong) {
    const Field solid = ball({2, 0, 0}, 1);
    EXPECT_NEAR(moved(solid, {0, 3, 0})({2, 3, 0}), -1, 1e-12);
    EXPECT_NEAR(mirrored(solid)({-2, 0, 0}), -1, 1e-12);
    EXPECT_NEAR(turned(solid, {0, 0, std::numbers::pi / 2}, {0, 0, 0})({0, 2, 0}), -1, 1e-12);
}

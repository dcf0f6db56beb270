// SPDX-License-Identifier: AGPL-3.0-or-later
#include "limb.h"

#include <gtest/gtest.h>

using namespace moldwright::samples;

TEST(Limb, StraightAndRoundIsACapsule) {
    const Field capsule = limb({{{0, 0, 0}, 2}, {{0, 0, 5}, 2}, {{0, 0, 10}, 2}});
    EXPECT_NEAR(capsule({2, 0, 3}), 0, 1e-6);
    EXPECT_NEAR(capsule({0, 5, 7}), 3, 1e-6);
    EXPECT_NEAR(capsule({0, 0, 12}), 0, 1e-6);
    EXPECT_NEAR(capsule({0, 0, -2}), 0, 1e-6);
    EXPECT_LT(capsule({0, 0, 5}), 0);
}

TEST(Limb, ThicknessIsMeasuredAlongFlat) {
    const Field leaf = limb({{{0, 0, 0}, 3, 1}, {{0, 0, 10}, 3, 1}}, Vector3d::UnitX());
    EXPECT_NEAR(leaf({1, 0, 5}), 0, 1e-6);
    EXPECT_NEAR(leaf({0, 3, 5}), 0, 1e-6);
}

TEST(Limb, PassesThroughItsStations) {
    const std::vector<Station> bent = {{{0, 0, 0}, 2}, {{4, 0, 6}, 1.5}, {{12, 0, 7}, 1}};
    const Field arm = limb(bent);
    EXPECT_NEAR(arm(bent[1].at + Vector3d(0, 1.5, 0)), 0, 1e-5);
    EXPECT_NEAR(arm(bent[2].at + Vector3d(0, 1, 0)), 0, 1e-5);
}

TEST(Limb, TaperGoesOnIntoTheTip) {
    const Field horn = limb({{{0, 0, 0}, 3}, {{0, 0, 10}, 1}});
    // Just past the end the section is still shrinking: no knob.
    EXPECT_GT(horn({0.97, 0, 10.2}), 0);
    EXPECT_NEAR(horn({0, 0, 11}), 0, 1e-6);
}

TEST(Limb, FarAwayItIsALowerBound) {
    const Field arm = limb({{{0, 0, 0}, 1}, {{10, 0, 0}, 1}});
    const double bound = arm({5, 40, 0});
    EXPECT_GT(bound, 0);
    EXPECT_LE(bound, 39);
}

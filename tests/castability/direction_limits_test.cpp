// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/direction_limits.h"

#include <gtest/gtest.h>

#include <random>

using namespace moldwright;

namespace {

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
}

Eigen::Vector3d leaningBy(double angle) {
    return {std::sin(radians(angle)), 0, std::cos(radians(angle))};
}

const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

} // namespace

TEST(DirectionLimits, WithoutAnAxisTheTiltAloneCounts) {
    const auto cap = capWithin({20}, up, 2);
    ASSERT_TRUE(cap);
    EXPECT_EQ(cap->middle, Eigen::Vector3d(-up));
    EXPECT_EQ(cap->radiusDegrees, 20);
}

TEST(DirectionLimits, AFixedAxisIsTheOnlyDirectionWhicheverWayItIsGiven) {
    for (const double way : {1.0, -1.0}) {
        const DirectionLimits limits{30, way * leaningBy(12), 0};
        const Directions directions = middleDirections(limits, up);
        EXPECT_TRUE(directions.d1.isApprox(leaningBy(12)));
        EXPECT_TRUE(directions.d2.isApprox(-leaningBy(12)));
        EXPECT_EQ(capWithin(limits, up, 1)->radiusDegrees, 0);
    }
}

TEST(DirectionLimits, LimitsThatExcludeEachOtherAllowNone) {
    EXPECT_TRUE(allows({30, leaningBy(34), 5}, up));
    EXPECT_FALSE(allows({30, leaningBy(36), 5}, up));
    EXPECT_FALSE(allows({0, leaningBy(1), 0}, up));
}

TEST(DirectionLimits, ACapLiesWithinBothLimitsAndTouchesThem) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(0, 1);
    for (int i = 0; i < 200; ++i) {
        const DirectionLimits limits{40 * number(random), leaningBy(60 * number(random)),
                                     30 * number(random)};
        const auto cap = capWithin(limits, up, 1);
        if (!cap)
            continue;
        const double fromUp = angleBetween(cap->middle, up);
        const double fromAxis = angleBetween(cap->middle, *limits.axis);
        EXPECT_LE(fromUp + cap->radiusDegrees, limits.maxTiltDegrees + 1e-6);
        EXPECT_LE(fromAxis + cap->radiusDegrees, limits.coneDegrees + 1e-6);
        EXPECT_NEAR(std::max(fromUp - limits.maxTiltDegrees, fromAxis - limits.coneDegrees) +
                        cap->radiusDegrees,
                    0, 1e-6);
    }
}

TEST(DirectionLimits, TheNearestDirectionIsItselfOrOnTheRim) {
    const DirectionCap cap{up, 10};
    EXPECT_EQ(cap.nearestTo(leaningBy(7)), leaningBy(7));
    EXPECT_TRUE(cap.nearestTo(leaningBy(50)).isApprox(leaningBy(10)));
    EXPECT_TRUE((DirectionCap{up, 0}.nearestTo(leaningBy(50)).isApprox(up)));
}

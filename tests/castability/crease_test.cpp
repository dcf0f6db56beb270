// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/crease.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace moldwright;
using Eigen::Vector3d;

namespace {

/// At the level plane, direction 1 leaning by `lean1` towards +x, direction 2 by `lean2`.
MoldState leaning(double lean1, double lean2) {
    const auto tilted = [](double lean) {
        return Vector3d(std::sin(radians(lean)), 0, std::cos(radians(lean)));
    };
    return {PartingPlane{}, {tilted(lean1), -tilted(lean2)}};
}

} // namespace

TEST(Crease, IsTheAngleBetweenTheDirectionsSeenAlongTheLine) {
    const MoldState state = leaning(20, -5);
    EXPECT_NEAR(creaseDegrees(state, Vector3d::UnitY()), 25, 1e-9);
    EXPECT_NEAR(creaseDegrees(state, -3 * Vector3d::UnitY()), 25, 1e-9);
    EXPECT_NEAR(creaseDegrees(state, Vector3d::UnitX()), 0, 1e-9) << "they lean along the line";
    EXPECT_NEAR(sharpestCreaseDegrees(state), 25, 1e-6);
}

TEST(Crease, ParallelDirectionsLeaveNone) {
    const MoldState state = leaning(17, 17);
    for (const double angle : {0.0, 0.3, 1.2, 2.9})
        EXPECT_NEAR(creaseDegrees(state, {std::cos(angle), std::sin(angle), 0}), 0, 1e-9);
    EXPECT_NEAR(sharpestCreaseDegrees(state), 0, 1e-9);
}

TEST(Crease, NoLineIsSharperThanTheSharpest) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int round = 0; round < 200; ++round) {
        PartingPlane plane;
        plane.normal = Vector3d(normal(random), normal(random), normal(random)).normalized();
        const auto leaned = [&](double side) {
            const Vector3d by = 0.3 * Vector3d(normal(random), normal(random), normal(random));
            return Vector3d((side * plane.normal + by).normalized());
        };
        const MoldState state{plane, {leaned(1), leaned(-1)}};
        if (state.directions.d1.dot(plane.normal) < 0.1 || state.directions.d2.dot(plane.normal) > -0.1)
            continue;
        const double sharpest = sharpestCreaseDegrees(state);
        const auto [u, v] = planeAxes(plane.normal);
        for (int k = 0; k < 64; ++k) {
            const double angle = k * 0.1;
            EXPECT_LE(creaseDegrees(state, std::cos(angle) * u + std::sin(angle) * v), sharpest + 1e-6);
        }
    }
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/pin_drawing.h"

#include "deformation/two_bodies.h"
#include "mesh/check.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

int pointAt(const BodyShape& body, const Eigen::Vector3d& place) {
    Eigen::Index nearest = 0;
    EXPECT_LT((body.V.rowwise() - place.transpose()).rowwise().norm().minCoeff(&nearest), 1e-9);
    return static_cast<int>(nearest);
}

/// By which factor the edges of the body's tetrahedra became shorter and longer.
std::pair<double, double> edgeRatios(const BodyShape& body, const Positions& X) {
    std::pair<double, double> ratios(1, 1);
    for (Eigen::Index t = 0; t < body.T.rows(); ++t)
        for (int a = 0; a < 4; ++a)
            for (int b = 0; b < a; ++b) {
                const double ratio = (X.row(body.T(t, a)) - X.row(body.T(t, b))).norm() /
                                     (body.V.row(body.T(t, a)) - body.V.row(body.T(t, b))).norm();
                ratios = {std::min(ratios.first, ratio), std::max(ratios.second, ratio)};
            }
    return ratios;
}

/// An arm 0.8 long and 0.1 thick, along the plane.
BodyShape armInPlane() {
    const test::Solid solid = test::solidBox({0, -0.05, -0.05}, {0.8, 0.05, 0.05}, {48, 6, 6});
    return {solid.tets.V, solid.tets.T, solid.F, {}, 0, 0};
}

} // namespace

TEST(PinDrawing, AnArmBendsToThePlaneAsAWholeAndNotAtThePointAlone) {
    BodyShape arm = armInPlane();
    arm.V.col(2).array() += 0.3;
    const int tip = pointAt(arm, {0.8, 0, 0.3});
    const int foot = pointAt(arm, {0, 0, 0.3});
    const Positions X = drawnIntoPlane(arm, {tip}, {});
    EXPECT_EQ(X(tip, 2), 0);
    EXPECT_GT(X(foot, 2), 0.2) << "what is not pinned stays where it was";
    const auto [shortest, longest] = edgeRatios(arm, X);
    EXPECT_GT(shortest, 0.8);
    EXPECT_LT(longest, 1.25);
}

TEST(PinDrawing, WhatLiesInThePlaneAlreadyStaysAsItIs) {
    const BodyShape arm = armInPlane();
    const Positions X = drawnIntoPlane(arm, {pointAt(arm, {0.8, 0, 0}), pointAt(arm, {0.4, 0, 0})}, {});
    EXPECT_LT((X - arm.V).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(PinDrawing, ArmsThatMeetInThePlaneLieBesideEachOther) {
    // Their tips go to the same place of the plane but for the thickness of one.
    const test::Solid low = test::solidBox({0, 0, -0.2}, {0.8, 0.1, -0.1}, {20, 3, 3});
    const test::Solid high = test::solidBox({0, 0.07, 0.1}, {0.8, 0.17, 0.2}, {20, 3, 3});
    const BodyShape arms = test::besideEachOther(low, high);
    const int lowTip = pointAt(arms, {0.8, 0.1 / 3, -0.2 + 0.1 / 3});
    const int highTip = pointAt(arms, {0.8, 0.07 + 0.2 / 3, 0.1 + 0.2 / 3});
    const Positions X = drawnIntoPlane(arms, {lowTip, highTip}, {});
    EXPECT_EQ(X(lowTip, 2), 0);
    EXPECT_EQ(X(highTip, 2), 0);
    EXPECT_TRUE(selfIntersections(IndexedMesh{X, arms.F}).empty());
}

TEST(PinDrawing, AStoppedTaskEndsIt) {
    const BodyShape arm = armInPlane();
    const Task task;
    task.cancel();
    EXPECT_EQ(drawnIntoPlane(arm, {pointAt(arm, {0.8, 0, 0.05})}, task).rows(), arm.V.rows());
}

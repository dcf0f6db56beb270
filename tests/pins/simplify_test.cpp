// SPDX-License-Identifier: AGPL-3.0-or-later
// Shapes whose medial axes are known.
#include "pins/simplify.h"

#include "known_axes.h"

#include "mesh/measures.h"
#include "pins/surface_samples.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace moldwright;
using namespace moldwright::test;

namespace {

/// Largest of both misses, in diagonals.
double worstMiss(const MedialMesh& axis, const IndexedMesh& mesh) {
    const Miss miss = missOf(axis, surfaceSamples(mesh, 0, 7));
    return std::max(miss.outside, miss.inside) / diagonal(mesh);
}

} // namespace

TEST(Simplify, ACapsuleIsAChainAlongItsAxis) {
    const IndexedMesh mesh = capsule(0.25, 1, 96, 120);
    const MedialMesh axis = reducedAxis(mesh, 10);
    ASSERT_EQ(axis.size(), 10);
    EXPECT_EQ(axis.edges.size(), 9u);
    EXPECT_TRUE(axis.triangles.empty());
    const std::vector<int> degree = degrees(axis);
    EXPECT_EQ(std::count(degree.begin(), degree.end(), 1), 2);
    EXPECT_EQ(std::count(degree.begin(), degree.end(), 2), 8);
    for (const MedialBall& ball : axis.balls) {
        EXPECT_NEAR(ball.radius, 0.25, 0.0025);
        EXPECT_LT(std::hypot(ball.centre.x(), ball.centre.y()), 0.0025);
    }
    EXPECT_LT(worstMiss(axis, mesh), 0.0005);
}

TEST(Simplify, ATorusIsACycle) {
    const IndexedMesh mesh = torus(1, 0.3, 160, 48);
    for (const int count : {12, 20}) {
        const MedialMesh axis = reducedAxis(mesh, count);
        ASSERT_EQ(axis.size(), count);
        EXPECT_EQ(axis.edges.size(), axis.balls.size());
        EXPECT_TRUE(axis.triangles.empty());
        for (const int degree : degrees(axis))
            EXPECT_EQ(degree, 2);
        // A chord of a regular polygon leaves the circle by its sagitta.
        const double sagitta = (1 - std::cos(std::numbers::pi / count)) / diagonal(mesh);
        EXPECT_LT(worstMiss(axis, mesh), 1.3 * sagitta + 0.001) << count;
    }
}

TEST(Simplify, AnEllipsoidIsAFlatEllipse) {
    const IndexedMesh mesh = ellipsoid(1, 0.6, 0.3, 5);
    for (const auto& [count, allowed] : {std::pair(20, 0.027), std::pair(50, 0.013)}) {
        const MedialMesh axis = reducedAxis(mesh, count);
        EXPECT_LE(axis.size(), count + 5);
        EXPECT_LT(worstMiss(axis, mesh), allowed) << count;
    }
    // What is left when the spikes are gone and the rim still has balls enough.
    Eigen::Vector3d reach = Eigen::Vector3d::Zero();
    for (const MedialBall& ball : reducedAxis(mesh, 1000).balls)
        reach = reach.cwiseMax(ball.centre.cwiseAbs());
    EXPECT_NEAR(reach.x(), (1 - 0.09) / 1, 0.02);
    EXPECT_NEAR(reach.y(), (0.36 - 0.09) / 0.6, 0.02);
    EXPECT_LT(reach.z(), 0.02);
}

TEST(Simplify, ABoxIsARectangleWithSheetsToItsEdges) {
    const IndexedMesh mesh = box({-1, -0.6, -0.3}, {1, 0.6, 0.3});
    const MedialMesh axis = reducedAxis(mesh, 40);
    int inRectangle = 0;
    for (const MedialBall& ball : axis.balls)
        if (ball.radius > 0.29) {
            ++inRectangle;
            EXPECT_NEAR(ball.radius, 0.3, 0.02);
            EXPECT_LT(std::abs(ball.centre.x()), 0.73);
            EXPECT_LT(std::abs(ball.centre.y()), 0.33);
        }
    EXPECT_GE(inRectangle, 4);
    EXPECT_LT(missOf(axis, surfaceSamples(mesh, 0, 7)).inside, 0.01 * diagonal(mesh));
}

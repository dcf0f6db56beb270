// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/plane_search.h"

#include "base/parallel.h"
#include "castability/directions.h"
#include "mesh/measures.h"
#include "support/finite_differences.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace moldwright;

TEST(VolumeAbove, OfABoxIsItsShare) {
    const IndexedMesh box = test::box({0, 0, 0}, {2, 3, 4});
    EXPECT_NEAR(volumeAbove(box, {Eigen::Vector3d::UnitZ(), 1}), 18, 1e-12);
    EXPECT_NEAR(volumeAbove(box, {-Eigen::Vector3d::UnitZ(), -1}), 6, 1e-12);
    EXPECT_NEAR(volumeAbove(box, {Eigen::Vector3d(1, 1, 1).normalized(), 100}), 0, 1e-12);
}

TEST(VolumeAbove, GradientMatchesFiniteDifferences) {
    const IndexedMesh shape = test::rotated(test::sphere({0.3, 0.1, -0.2}, 1, 4), {0.6, 0.8, 0}, 0.4);
    const PartingPlane plane{Eigen::Vector3d(0.3, -0.2, 0.9).normalized(), 0.25};
    VolumeGradient gradient;
    (void)volumeAbove(shape, plane, &gradient);
    Eigen::VectorXd x(4);
    x << plane.normal, plane.offset;
    Eigen::VectorXd analytic(4);
    analytic << gradient.normal, gradient.offset;
    // The normal leaves the unit sphere here, and with it the length of distances: compare along the tangent.
    const auto at = [&](const Eigen::VectorXd& y) {
        const double length = y.head<3>().norm();
        return volumeAbove(shape, {y.head<3>() / length, y[3] / length});
    };
    EXPECT_LT(test::relativeError(analytic, test::finiteDifferences(at, x)), 1e-4);
}

TEST(PlaneSearch, ASphereIsPartedNearItsMiddle) {
    const IndexedMesh ball = test::sphere({10, 20, 30}, 5, 4);
    PlaneSearch search;
    search.draftDegrees = 0;
    const auto planes = findPlanes(ball, search);
    ASSERT_FALSE(planes.empty());
    EXPECT_NEAR(planes.front().state.plane.distance({10, 20, 30}), 0, 0.1);
    EXPECT_LT(planes.front().violatingAreaFraction, 0.06);
    EXPECT_GT(planes.front().smallerVolumeFraction, 0.45);
}

TEST(PlaneSearch, AFlatBackedPartPartsAtItsBack) {
    // A drafted frustum: castable as it is, all of it on side 1.
    IndexedMesh frustum = test::box({-2, -2, 3}, {2, 2, 4});
    for (int v = 4; v < 8; ++v)
        frustum.V.row(v).head<2>() *= 0.9;
    const auto planes = findPlanes(frustum, PlaneSearch{});
    ASSERT_FALSE(planes.empty());
    EXPECT_EQ(planes.front().energy, 0);
    EXPECT_EQ(planes.front().smallerVolumeFraction, 0);
    EXPECT_TRUE(planes.front().state.plane.normal.isApprox(Eigen::Vector3d::UnitZ()));
    EXPECT_NEAR(planes.front().state.plane.offset, 3, 1e-12);
}

TEST(PlaneSearch, CandidatesAreSortedDistinctAndWithinTheTiltCap) {
    const IndexedMesh shape = test::torus(2, 0.6, 40, 20);
    PlaneSearch search;
    search.count = 8;
    search.maxTiltDegrees = 20;
    const auto planes = findPlanes(shape, search);
    ASSERT_GT(planes.size(), 3U);
    for (const PlaneCandidate& c : planes) {
        EXPECT_GE(c.state.directions.d1.dot(c.state.plane.normal), std::cos(radians(20.001)));
        EXPECT_GE(-c.state.directions.d2.dot(c.state.plane.normal), std::cos(radians(20.001)));
        EXPECT_NEAR(c.state.directions.d1.norm(), 1, 1e-12);
    }
}

TEST(PlaneSearch, SameAnswerForAnyNumberOfThreads) {
    const IndexedMesh shape = test::torus(2, 0.6, 40, 20);
    setThreadCount(1);
    const auto one = findPlanes(shape, PlaneSearch{});
    setThreadCount(3);
    const auto three = findPlanes(shape, PlaneSearch{});
    setThreadCount(0);
    ASSERT_EQ(one.size(), three.size());
    for (std::size_t i = 0; i < one.size(); ++i)
        EXPECT_EQ(one[i].state, three[i].state);
}

TEST(Directions, ConeCoordinatesRoundTripAndGradientMatches) {
    const ConeDirection cone(Eigen::Vector3d(0.1, -0.7, 0.4).normalized(), 30);
    const Eigen::Vector2d c(0.4, -0.9);
    EXPECT_TRUE(cone.coordinates(cone.direction(c)).isApprox(c, 1e-9));
    const Eigen::Vector3d g(0.3, 0.2, -0.5);
    const auto at = [&](const Eigen::VectorXd& x) { return g.dot(cone.direction(x)); };
    EXPECT_LT(test::relativeError(cone.pullBack(c, g), test::finiteDifferences(at, c)), 1e-7);
}

TEST(Directions, ALeaningPrismOpensAlongItsAxis) {
    // A box sheared by 20°: only along its slanted edges do both halves come off without undercut.
    IndexedMesh prism = test::splitInFour(test::box({-1, -1, -1}, {1, 1, 1}));
    prism.V.col(0) += std::tan(radians(20)) * prism.V.col(2);
    const PartingPlane plane;
    const Directions best = bestDirections(prism, plane, 0, 30);
    const Eigen::Vector3d axis(std::sin(radians(20)), 0, std::cos(radians(20)));
    EXPECT_LT(degrees(std::acos(best.d1.dot(axis))), 0.5);
    EXPECT_LT(degrees(std::acos(-best.d2.dot(axis))), 0.5);
    const Directions capped = bestDirections(prism, plane, 0, 10);
    EXPECT_NEAR(degrees(std::acos(capped.d1.z())), 10, 0.5);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/plane_search.h"

#include "base/parallel.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;

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
    search.limits.maxTiltDegrees = 20;
    const auto planes = findPlanes(shape, search);
    ASSERT_GT(planes.size(), 3U);
    for (const PlaneCandidate& c : planes) {
        EXPECT_GE(c.state.directions.d1.dot(c.state.plane.normal), std::cos(radians(20.001)));
        EXPECT_GE(-c.state.directions.d2.dot(c.state.plane.normal), std::cos(radians(20.001)));
        EXPECT_NEAR(c.state.directions.d1.norm(), 1, 1e-12);
    }
}

TEST(PlaneSearch, DirectionsStayAboutThePressAxis) {
    const IndexedMesh shape = test::rotated(test::torus(2, 0.6, 40, 20), {0.6, 0.8, 0}, 0.4);
    const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 2) / 3;
    for (const double cone : {0.0, 8.0})
        for (const bool normal : {false, true}) {
            PlaneSearch search;
            search.limits = {15, axis, cone};
            search.normalDirections = normal;
            const auto planes = findPlanes(shape, search);
            ASSERT_FALSE(planes.empty());
            for (const PlaneCandidate& c : planes)
                for (const Eigen::Vector3d& d : {c.state.directions.d1, c.state.directions.d2}) {
                    EXPECT_GE(std::abs(d.dot(axis)), std::cos(radians(cone + 1e-4)));
                    EXPECT_GE(std::abs(d.dot(c.state.plane.normal)),
                              std::cos(radians(normal ? 1e-4 : 15.0001)));
                }
        }
}

TEST(PlaneSearch, AlongAnAxisTheBestPlaneIsFoundStill) {
    // The ring lies square to z: along z its middle plane leaves nothing undercut but what the draft asks.
    PlaneSearch search;
    search.draftDegrees = 0;
    search.limits = {30, Eigen::Vector3d(0, 0, -1), 0};
    const auto planes = findPlanes(test::torus(2, 0.6, 40, 20), search);
    ASSERT_FALSE(planes.empty());
    EXPECT_NEAR(planes.front().state.plane.offset, 0, 0.05);
    EXPECT_EQ(std::abs(planes.front().state.directions.d1.z()), 1);
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

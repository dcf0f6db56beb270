// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/cluster.h"

#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;

TEST(Cluster, LeavesWhatIsCoarseEnough) {
    const IndexedMesh ball = test::sphere({0, 0, 0}, 1, 3);
    EXPECT_EQ(cluster(ball, ball.faceCount()).F, ball.F);
}

TEST(Cluster, KeepsTheShapeAndStaysClosed) {
    const IndexedMesh ball = test::sphere({4, 5, 6}, 1, 6);
    const IndexedMesh coarse = cluster(ball, 2000);
    EXPECT_GT(coarse.faceCount(), 1000);
    EXPECT_LT(coarse.faceCount(), 3500);
    EXPECT_NEAR(volume(coarse), volume(ball), 0.01 * volume(ball));
    EXPECT_NEAR(surfaceArea(coarse), surfaceArea(ball), 0.02 * surfaceArea(ball));
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int f = 0; f < coarse.faceCount(); ++f)
        sum += doubleAreaVector(coarse, f);
    EXPECT_LT(sum.norm(), 1e-12);
}

TEST(Cluster, KeepsSharpEdgesInPlace) {
    IndexedMesh box = test::box({-1, -1, -1}, {1, 1, 1});
    for (int i = 0; i < 5; ++i)
        box = test::splitInFour(box);
    const IndexedMesh coarse = cluster(box, 1500);
    EXPECT_LT(coarse.faceCount(), 4000);
    EXPECT_NEAR(volume(coarse), 8, 0.05);
}

TEST(Cluster, AThinWireStaysOne) {
    IndexedMesh wire = test::box({-1, -1, -1}, {1, 1, 1});
    for (int i = 0; i < 5; ++i)
        wire = test::splitInFour(wire);
    wire.V.rightCols<2>() *= 1e-3;
    EXPECT_NEAR(volume(cluster(wire, 1000)), volume(wire), 0.2 * volume(wire));
}

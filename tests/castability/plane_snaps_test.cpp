// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/plane_snaps.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <random>

using namespace moldwright;
using Eigen::Vector3d;

TEST(PlaneSnaps, SquareToAnAxisKeepsItsSides) {
    PartingPlane like;
    like.normal = Vector3d(-0.9, 0.3, 0.2).normalized();
    const PartingPlane plane = squareTo(Vector3d::UnitX(), {4, 5, 6}, like);
    EXPECT_EQ(plane.normal, Vector3d(-1, 0, 0));
    EXPECT_EQ(plane.offset, -4);
}

TEST(PlaneSnaps, ThreePointsLieInTheirPlaneWhateverTheirOrder) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-50, 50);
    for (int round = 0; round < 200; ++round) {
        const auto point = [&] { return Vector3d(number(random), number(random), number(random)); };
        const Vector3d a = point();
        const Vector3d b = point();
        const Vector3d c = point();
        const auto plane = planeThrough({a, b, c}, {});
        ASSERT_TRUE(plane);
        for (const Vector3d& p : {a, b, c})
            EXPECT_NEAR(plane->distance(p), 0, 1e-9);
        EXPECT_GE(plane->normal.z(), 0);
        const auto turned = planeThrough({c, b, a}, {});
        ASSERT_TRUE(turned);
        EXPECT_TRUE(turned->normal.isApprox(plane->normal));
    }
}

TEST(PlaneSnaps, PointsOnALineGiveNone) {
    EXPECT_FALSE(planeThrough({Vector3d(0, 0, 0), Vector3d(1, 1, 1), Vector3d(5, 5, 5)}, {}));
    EXPECT_FALSE(planeThrough({Vector3d(0, 0, 0), Vector3d(0, 0, 0), Vector3d(5, 5, 5)}, {}));
}

TEST(PlaneSnaps, APlaneLiesInItsFace) {
    const IndexedMesh cube = test::box(Vector3d(-1, -2, -3), Vector3d(1, 2, 3));
    PartingPlane like;
    like.normal = Vector3d(0.2, -1, 0.1).normalized();
    for (int f = 0; f < cube.faceCount(); ++f) {
        const auto plane = planeOfFace(cube, f, like);
        ASSERT_TRUE(plane);
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(plane->distance(cube.corner(f, k)), 0, 1e-12);
        EXPECT_GE(plane->normal.dot(like.normal), 0);
    }
}

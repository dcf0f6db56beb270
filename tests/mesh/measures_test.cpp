// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/measures.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace moldwright;

TEST(Measures, BoxHasItsHandCalculatedValues) {
    const IndexedMesh box = test::box({1, 2, 3}, {3, 5, 7});
    EXPECT_DOUBLE_EQ(volume(box), 24);
    EXPECT_DOUBLE_EQ(surfaceArea(box), 2 * (2 * 3 + 3 * 4 + 2 * 4));
    EXPECT_DOUBLE_EQ(diagonal(box), std::sqrt(4 + 9 + 16));
    EXPECT_TRUE(centroid(box).isApprox(Eigen::Vector3d(2, 3.5, 5)));
}

TEST(Measures, FarFromTheOriginNothingCancels) {
    const Eigen::Vector3d far(1e7, -2e7, 3e7);
    EXPECT_NEAR(volume(test::box(far, far + Eigen::Vector3d::Ones())), 1, 1e-6);
}

TEST(Measures, SphereApproachesItsFormulas) {
    const IndexedMesh sphere = test::sphere({0, 0, 0}, 2, 5);
    EXPECT_NEAR(volume(sphere), 4.0 / 3 * std::numbers::pi * 8, 0.1);
    EXPECT_NEAR(surfaceArea(sphere), 4 * std::numbers::pi * 4, 0.1);
}

TEST(Measures, BoundingBoxIgnoresUnusedPoints) {
    IndexedMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
    mesh.V.conservativeResize(9, 3);
    mesh.V.row(8) << 100, 100, 100;
    EXPECT_EQ(boundingBox(mesh).max(), Eigen::Vector3d(1, 1, 1));
}

TEST(Measures, ComponentsAreNumberedByFirstFace) {
    const Components parts =
        connectedComponents(test::together(test::box({0, 0, 0}, {1, 1, 1}), test::sphere({5, 0, 0}, 1, 1)));
    EXPECT_EQ(parts.count, 2);
    EXPECT_EQ(parts.ofFace.front(), 0);
    EXPECT_EQ(parts.ofFace.back(), 1);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/colours.h"
#include "scene/shading.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::scene;
using Eigen::Vector3d;

TEST(Shading, ASphereIsSmoothAndABoxIsSharp) {
    const IndexedMesh sphere = test::sphere(Vector3d::Zero(), 1, 3);
    EXPECT_EQ(shade(sphere).points.rows(), sphere.V.rows());
    EXPECT_EQ(shade(test::box(Vector3d::Zero(), Vector3d::Ones())).points.rows(), 24);
}

TEST(DraftClasses, TurnFromWarmToBlueAtTheRequiredDraft) {
    EXPECT_EQ(draftClass(0.99, 1), 3);
    EXPECT_EQ(draftClass(1, 1), 4);
    EXPECT_EQ(draftClass(-80, 1), 0);
    EXPECT_EQ(draftClass(60, 1), 6);
    EXPECT_EQ(draftClass(4.9, 5), 3);
    EXPECT_EQ(draftClass(5, 5), 5);
}

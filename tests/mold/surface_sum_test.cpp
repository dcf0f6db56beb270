// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/surface_sum.h"

#include "mesh/check.h"
#include "mesh/measures.h"
#include "mold/half.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <memory>

using namespace moldwright;
using Eigen::Vector2d;

namespace {

SharedMesh shared(IndexedMesh mesh) {
    return std::make_shared<const IndexedMesh>(std::move(mesh));
}

} // namespace

TEST(SurfaceSum, JoinsBordersThatMeet) {
    const IndexedMesh ball = test::sphere({0, 0, 0}, 10, 3);
    const SurfaceSum whole = sumOf({{shared(sideOf(ball, 1, 99))}, {shared(sideOf(ball, 2, -99))}});
    EXPECT_TRUE(whole.open.empty());
    EXPECT_TRUE(diagnose(whole.mesh).usable());
    EXPECT_EQ(whole.mesh.vertexCount(), ball.vertexCount());
    EXPECT_NEAR(volume(whole.mesh), volume(ball), 1e-9);
}

TEST(SurfaceSum, KeepsCopiesApartAndTheirBordersOpen) {
    const SharedMesh dome = shared(sideOf(test::sphere({0, 0, 0}, 10, 3), 1, 99));
    const SurfaceSum one = sumOf({{dome}});
    const SurfaceSum three = sumOf({{dome}, {dome, Vector2d(25, 0)}, {dome, Vector2d(0, 25)}});
    EXPECT_GT(one.open.size(), 10U);
    EXPECT_EQ(three.open.size(), 3 * one.open.size());
    EXPECT_EQ(three.mesh.faceCount(), 3 * dome->faceCount());
    EXPECT_EQ(connectedComponents(three.mesh).count, 3);
    EXPECT_EQ(boundingBox(three.mesh).max().y(), boundingBox(*dome).max().y() + 25);
}

TEST(SurfaceSum, TurnsInsideOut) {
    const SharedMesh ball = shared(test::sphere({0, 0, 0}, 10, 3));
    EXPECT_NEAR(volume(sumOf({{ball, Vector2d::Zero(), true}}).mesh), -volume(*ball), 1e-9);
}

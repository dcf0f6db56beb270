// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/drafted_prism.h"

#include "mesh/check.h"
#include "mesh/measures.h"
#include "mesh/weld.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moldwright;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double grid = 1.0 / 65536;

PrismRequest request(PlanShape base, double up, double down) {
    PrismRequest asked;
    asked.base = std::move(base);
    asked.height = {up, down};
    asked.directions = {std::vector<Vector3d>{Vector3d::UnitZ()}, std::vector<Vector3d>{-Vector3d::UnitZ()}};
    asked.draftDegrees = 10;
    asked.grid = grid;
    return asked;
}

/// Volume of a frustum over a × b, height h, lean l.
double frustum(double a, double b, double h, double l) {
    return a * b * h - (a + b) * l * h * h + 4.0 / 3 * l * l * h * h * h;
}

bool sound(const IndexedMesh& mesh) {
    return diagnose(mesh).usable();
}

} // namespace

TEST(DraftedPrism, OverARectangleIsAFrustum) {
    const DraftedPrism prism = draftedPrism(request(planRectangle({0, 0}, {6, 4}), 3, 2)).value();
    const IndexedMesh solid = *prismSolid(prism);
    const double lean = std::tan(radians(10));
    EXPECT_TRUE(sound(solid));
    EXPECT_NEAR(volume(solid), frustum(6, 4, 3, lean) + frustum(6, 4, 2, lean), 1e-3);
    const Eigen::AlignedBox3d box = boundingBox(solid);
    EXPECT_EQ(box.max().z(), 3);
    EXPECT_EQ(box.min().z(), -2);
}

TEST(DraftedPrism, OnOneSideHasAFlatFoot) {
    const DraftedPrism prism = draftedPrism(request(planCircle({1, 2}, 5, 24), 3, 0)).value();
    const IndexedMesh solid = *prismSolid(prism);
    EXPECT_TRUE(sound(solid));
    EXPECT_EQ(boundingBox(solid).min().z(), 0);
    EXPECT_FALSE(prism.stands(2));
}

TEST(DraftedPrism, FollowsATiltedDirection) {
    PrismRequest asked = request(planCircle({0, 0}, 5, 32), 4, 0);
    asked.directions[0] = {Vector3d(std::sin(radians(30)), 0, std::cos(radians(30)))};
    asked.draftDegrees = 5;
    const DraftedPrism prism = draftedPrism(asked).value();
    double lowest = 90;
    const IndexedMesh walls = *prismSurface(prism, 1);
    for (int f = 0; f < walls.faceCount(); ++f)
        lowest = std::min(lowest,
                          draftDegrees(doubleAreaVector(walls, f).normalized().dot(asked.directions[0][0])));
    EXPECT_NEAR(lowest, 5, 0.02);
    // The lid has moved along with the direction.
    Vector2d middle = Vector2d::Zero();
    for (const Vector2d& p : prism.lid[0])
        middle += p / 32;
    EXPECT_NEAR(middle.x(), 4 * std::tan(radians(30)), 0.1);
}

TEST(DraftedPrism, IsRefusedWhereItClosesBeforeItsHeight) {
    EXPECT_FALSE(draftedPrism(request(planRectangle({0, 0}, {6, 1}), 3, 0)));
    const Result<DraftedPrism> lower = prismAsHighAsFits(request(planRectangle({0, 0}, {6, 1}), 3, 0));
    ASSERT_TRUE(lower);
    EXPECT_GT(lower->height[0], 0.5);
    EXPECT_TRUE(sound(*prismSolid(*lower)));
}

TEST(DraftedPrism, OpensIntoTheWallOfAnotherWithTheSamePoints) {
    DraftedPrism host = draftedPrism(request(planRectangle({-10, 0}, {10, 8}), 3, 3)).value();
    PrismRequest asked = request(planRectangle({-2, -9}, {3, 0}), 2, 2);
    asked.openings = {{2, {host.slope[0][0], host.slope[1][0]}}};
    const DraftedPrism guest = draftedPrism(asked).value();
    IndexedMesh all;
    const auto add = [&](const IndexedMesh& mesh) { all = test::together(all, mesh); };
    for (const int side : {1, 2}) {
        add(*prismSurface(host, side, {{0, &guest}}));
        add(*prismSurface(guest, side));
    }
    const IndexedMesh joined = weldEqualPoints(all).mesh;
    EXPECT_TRUE(sound(joined));
    EXPECT_EQ(diagnose(joined).components, 1);
    // Together they have their volumes: the guest's end leans with the host's wall.
    EXPECT_NEAR(volume(joined), volume(*prismSolid(host)) + volume(*prismSolid(guest)), 1e-3);
}

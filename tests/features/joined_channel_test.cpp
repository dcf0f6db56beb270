// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/joined_channel.h"

#include "castability/certificate.h"
#include "features/drafted_prism.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "support/casts.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector3d;

namespace {

constexpr double grid = 1.0 / 65536;

DraftedPrism channel(double fromY, double toY, bool open) {
    PrismRequest asked;
    asked.base = planRectangle({-1.1, fromY}, {1.2, toY});
    if (open)
        asked.openings = {{2, {0, 0}}};
    asked.height = {1, 1};
    asked.directions = {std::vector<Vector3d>{Vector3d::UnitZ()}, std::vector<Vector3d>{-Vector3d::UnitZ()}};
    asked.grid = grid;
    return draftedPrism(asked).value();
}

} // namespace

TEST(JoinedChannel, IsStillACast) {
    const IndexedMesh cast = ball(10, 4).mesh;
    const DraftedPrism stub = channel(8, 15, false);
    const auto joined = joinedSolid(cast, {*prismSolid(stub)}, {Directions{}, 1, grid, {}});
    ASSERT_TRUE(joined);
    EXPECT_TRUE(certify(*joined, labelSides(*joined, {}), {}, 1).holds());
    EXPECT_GT(volume(*joined), volume(cast));
    EXPECT_LT(volume(*joined), volume(cast) + volume(*prismSolid(stub)));
}

TEST(JoinedChannel, OpensWhereItGoesOn) {
    const IndexedMesh cast = ball(10, 4).mesh;
    const DraftedPrism stub = channel(8, 15, true);
    const std::vector<Vector3d> points = openingPoints(stub);
    EXPECT_FALSE(joinedSolid(cast, {*prismSolid(stub)}, {Directions{}, 1, grid, {}}))
        << "its upright end has no draft";
    const auto joined = joinedSolid(cast, {*prismSolid(stub)}, {Directions{}, 1, grid, points});
    ASSERT_TRUE(joined);
    const IndexedMesh opened = openedAt(*joined, points);
    EXPECT_EQ(opened.faceCount(), joined->faceCount() - 4);
    EXPECT_EQ(diagnose(opened).boundaryLoops, 1);
}

TEST(JoinedChannel, OfAFlatBackedCastStaysFlat) {
    const IndexedMesh cast = frusta(20, 10, 5, 0, 0.1).mesh;
    PrismRequest asked;
    asked.base = planRectangle({-1.1, 4}, {1.2, 9});
    asked.height = {1, 0};
    asked.directions[0] = {Vector3d::UnitZ()};
    asked.grid = grid;
    const auto joined =
        joinedSolid(cast, {*prismSolid(draftedPrism(asked).value())}, {Directions{}, 1, grid, {}});
    ASSERT_TRUE(joined);
    EXPECT_EQ(boundingBox(*joined).min().z(), 0);
    EXPECT_TRUE(certify(*joined, labelSides(*joined, {}), {}, 1).holds());
}

TEST(JoinedChannel, IsRefusedWithoutDraft) {
    const IndexedMesh cast = ball(10, 4).mesh;
    EXPECT_FALSE(joinedSolid(cast, {box({-1, 8, -1}, {1, 15, 1})}, {Directions{}, 1, grid, {}}));
}

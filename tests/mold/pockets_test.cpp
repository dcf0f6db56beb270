// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/pockets.h"

#include "mesh/measures.h"
#include "support/casts.h"
#include "support/molds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

const double lean = std::tan(radians(5));

MoldSettings withPockets(int count, PocketShape shape, int side) {
    MoldSettings settings;
    settings.floor = settings.ceiling = 12;
    settings.pockets.count = count;
    settings.pockets.shape = shape;
    settings.pockets.side = side;
    return settings;
}

Directions straight() {
    return {Vector3d::UnitZ(), -Vector3d::UnitZ()};
}

} // namespace

TEST(Pockets, HoldTheInsertWithItsClearance) {
    PocketSettings settings; // an M6 nut
    const double grid = std::ldexp(1.0, -16);
    const Result<InsertPocket> pocket = insertPocket(settings, {30, 20}, straight(), 1, grid);
    ASSERT_TRUE(pocket) << pocket.error().english();
    EXPECT_FALSE(pocket->prism.stands(1));
    ASSERT_EQ(pocket->prism.lid[1].size(), 6U);
    for (std::size_t k = 0; k < 6; ++k) {
        const Vector2d middle = (pocket->prism.lid[1][k] + pocket->prism.lid[1][(k + 1) % 6]) / 2;
        EXPECT_NEAR((middle - Vector2d(30, 20)).norm(), 5 + 0.1, 1e-4) << "half the way across flats";
        const Vector2d above = (pocket->prism.base[k] + pocket->prism.base[(k + 1) % 6]) / 2;
        EXPECT_NEAR((above - Vector2d(30, 20)).norm(), 5.1 + 5.5 * std::tan(radians(1.5)), 1e-4);
    }
}

TEST(Pockets, OfARectangleHaveTheVolumeCalculatedByHand) {
    MoldSettings settings = withPockets(1, PocketShape::Rectangle, 1);
    settings.pockets.width = 6;
    settings.pockets.length = 12;
    settings.pockets.depth = 4;
    const Result<Mold> mold = moldOf(frusta(40, 30, 5, 3, lean), settings);
    expectVerified(mold);
    const double wider = 2 * 4 * std::tan(radians(1.5));
    const double a = 12.2, b = 6.2;
    const double volumeByHand = 4 * (a * b + (a + b) * wider / 2 + wider * wider / 3);
    EXPECT_NEAR(mold->otherVolume, volumeByHand, 1e-5 * volumeByHand);
    const double cavity1 = mold->half1.volume + mold->otherVolume;
    const double block1 = mold->half1.size.prod();
    MoldSettings without = settings;
    without.pockets.count = 0;
    const Result<Mold> plain = moldOf(frusta(40, 30, 5, 3, lean), without);
    EXPECT_NEAR(block1 - cavity1, plain->half1.size.prod() - plain->half1.volume, 1e-3) << "in half 1 alone";
}

TEST(Pockets, StandInAnyHalfWithEveryFeature) {
    for (const int side : {0, 1, 2})
        for (const PocketShape shape : {PocketShape::Round, PocketShape::Hexagon, PocketShape::Rectangle}) {
            MoldSettings settings = everyFeature();
            settings.pockets = withPockets(4, shape, side).pockets;
            settings.floor = settings.ceiling = 10;
            settings.bolts.count = 2;
            const Result<Mold> mold = moldOf(frusta(40, 30, 5, 3, lean), settings);
            expectVerified(mold);
            EXPECT_EQ(count(*mold, "pocket"), 4);
            for (const ThinSteel& thin : mold->steelOfEach)
                if (thin.first == "Pocket" || thin.second == "Pocket") {
                    EXPECT_GE(thin.thickness, settings.leastSteel - 1e-6) << thin.first << ' ' << thin.second;
                }
        }
}

TEST(Pockets, FollowObliqueDirections) {
    for (const auto& [s1, s2] : {std::pair{0.35, -0.1}, std::pair{0.3, 0.3}}) {
        const KnownCast cast = sheared(ball(15, 3), s1, s2);
        ASSERT_GT(std::acos(cast.state.directions.d1.z()), radians(15));
        MoldSettings settings = withPockets(3, PocketShape::Round, 0);
        settings.keys.count = 4;
        const Result<Mold> mold = moldOf(cast, settings);
        expectVerified(mold);
        for (const MoldFeature& feature : mold->features)
            if (feature.kind == "pocket") {
                for (const Vector2d& p : feature.outline)
                    EXPECT_GE((p - feature.stands->place).norm(), 5.1 - 1e-3);
            }
    }
}

TEST(Pockets, OfEveryShapeFollowSteepDirections) {
    const KnownCast cast = sheared(ball(15, 3), 0.55, -0.3);
    for (const PocketShape shape : {PocketShape::Round, PocketShape::Hexagon, PocketShape::Rectangle})
        for (const int side : {0, 1, 2})
            for (const double degrees : {0.0, 30.0, 75.0}) {
                const Eigen::AngleAxisd turn(radians(degrees), Vector3d::UnitZ());
                const Directions directions{turn * cast.state.directions.d1, turn * cast.state.directions.d2};
                PocketSettings settings = withPockets(1, shape, side).pockets;
                const Result<InsertPocket> pocket =
                    insertPocket(settings, {3, 4}, directions, 1, 1.0 / 65536);
                ASSERT_TRUE(pocket) << pocket.error().english();
                const double room =
                    (shape == PocketShape::Rectangle ? std::min(settings.width, settings.length)
                                                     : settings.width) /
                    2;
                for (const PlanShape& lid : pocket->prism.lid)
                    for (std::size_t k = 0; k < lid.size(); ++k) {
                        const double to = outwardNormal(lid, k).dot(lid[k] - Vector2d(3, 4));
                        EXPECT_GE(to, room + settings.clearance - 1e-4) << "the insert has room at its floor";
                        EXPECT_GE(outwardNormal(lid, k).dot(pocket->prism.base[k] - lid[k]), -1e-4)
                            << "and on its way there";
                    }
            }
}

TEST(Pockets, StandWhereTheyArePutAndAreRefusedInTheWay) {
    MoldSettings settings = withPockets(2, PocketShape::Round, 2);
    settings.placed = {{Placeable::Pocket, 1, {-40, 3}}};
    const Result<Mold> mold = moldOf(frusta(40, 30, 5, 3, lean), settings);
    expectVerified(mold);
    const auto second = std::ranges::find_if(mold->features, [](const MoldFeature& feature) {
        return feature.stands && feature.stands->kind == Placeable::Pocket && feature.stands->number == 1;
    });
    ASSERT_NE(second, mold->features.end());
    EXPECT_EQ(second->stands->place, Vector2d(-40, 3));
    EXPECT_TRUE(second->byHand);
    EXPECT_GT(mold->blockSize.x() / 2, 45) << "the block grows round it";
    settings.placed = {{Placeable::Pocket, 0, {0, 0}}};
    const Result<Mold> refused = moldOf(frusta(40, 30, 5, 3, lean), settings);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().english().find("Pocket 1"), std::string::npos) << refused.error().english();
}

TEST(Pockets, TooDeepForTheHalfAreRefusedByName) {
    MoldSettings settings = withPockets(1, PocketShape::Hexagon, 2);
    settings.floor = 5;
    settings.pockets.depth = 7;
    const Result<Mold> mold = moldOf(frusta(40, 30, 5, 3, lean), settings);
    ASSERT_FALSE(mold);
    EXPECT_NE(mold.error().english().find("half 2"), std::string::npos) << mold.error().english();
    settings.pockets.depth = 6; // the half is 8 mm thick, 2 mm stay
    expectVerified(moldOf(frusta(40, 30, 5, 3, lean), settings));
}

TEST(Pockets, InAShellKeepTheirSteel) {
    MoldSettings settings = withPockets(4, PocketShape::Hexagon, 2);
    settings.shape = BlockShape::Shell;
    const Result<Mold> mold = moldOf(ball(20, 3), settings);
    expectVerified(mold);
    EXPECT_GE(mold->minWall, settings.leastSteel - 1e-4) << "but for the grid";
}

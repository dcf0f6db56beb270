// SPDX-License-Identifier: AGPL-3.0-or-later
// Holes that nothing is cast in: for bolts and for ejector pins.
#include "mesh/check.h"
#include "mesh/measures.h"
#include "mold/free_place.h"
#include "mold/mold.h"
#include "support/casts.h"
#include "support/molds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector3d;

namespace {

const double lean = std::tan(radians(5));

/// Area of the polygon of 32 corners round a circle.
double roundArea(double diameter) {
    return 32 * std::tan(std::numbers::pi / 32) * diameter * diameter / 4;
}

} // namespace

TEST(BoltHoles, PassThroughBothHalves) {
    MoldSettings settings;
    settings.bolts.count = 4;
    settings.bolts.diameter = 5;
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), settings);
    expectVerified(mold);
    EXPECT_EQ(count(*mold, "bolt"), 4);
    const double height = mold->half1.size.z() + mold->half2.size.z();
    EXPECT_NEAR(mold->otherVolume, 4 * roundArea(5) * height, 1e-3 * mold->otherVolume);
    EXPECT_EQ(diagnose(*mold->half1.mesh).genus, 4);
    EXPECT_EQ(diagnose(*mold->half2.mesh).genus, 4);
    for (const ThinSteel& thin : mold->steel)
        if (thin.first == "Bolt hole" || thin.second == "Bolt hole") {
            EXPECT_GE(thin.thickness, settings.bolts.clear - 1e-4) << thin.first << ", " << thin.second;
        }
}

TEST(BoltHoles, KeepTheirWallToTheBlocksFaces) {
    MoldSettings settings;
    settings.bolts.count = 8;
    settings.bolts.wall = 4;
    const Result<Mold> mold = moldOf(frusta(40, 30, 5, 3, lean), settings);
    expectVerified(mold);
    const Eigen::AlignedBox3d block = boundingBox(*mold->half1.mesh);
    for (const MoldFeature& feature : mold->features)
        if (feature.kind == "bolt")
            for (const int axis : {0, 1}) {
                EXPECT_GE(feature.place[axis] - block.min()[axis], 4 + 6.6 / 2 - 1e-9);
                EXPECT_GE(block.max()[axis] - feature.place[axis], 4 + 6.6 / 2 - 1e-9);
            }
}

TEST(BoltHoles, FollowThePlanesNormalWhereDirectionsAreOblique) {
    MoldSettings settings = everyFeature();
    settings.bolts.count = 4;
    for (const auto& [s1, s2] : {std::pair{0.35, -0.1}, std::pair{-0.4, 0.3}})
        expectVerified(moldOf(sheared(ball(15, 4), s1, s2), settings));
}

TEST(BoltHoles, AndKeysAreAsManyAsAreOffered) {
    for (const int wanted : {9, 12, mostRound}) {
        MoldSettings settings;
        settings.bolts.count = wanted;
        Result<Mold> mold = moldOf(frusta(120, 90, 5, 3, lean), settings);
        ASSERT_TRUE(mold) << mold.error().english();
        expectVerified(mold);
        EXPECT_EQ(count(*mold, "bolt"), wanted);
        settings.bolts.count = 0;
        settings.keys.count = wanted;
        mold = moldOf(frusta(120, 90, 5, 3, lean), settings);
        ASSERT_TRUE(mold) << mold.error().english();
        expectVerified(mold);
        EXPECT_EQ(count(*mold, "key"), wanted);
        EXPECT_GE(mold->minWall, settings.leastSteel - 1e-6);
    }
}

TEST(BoltHoles, WithoutRoomAreRefused) {
    MoldSettings settings;
    settings.bolts.count = 8;
    settings.bolts.diameter = 120;
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), settings);
    ASSERT_FALSE(mold);
    EXPECT_EQ(mold.error().code, ErrorCode::Impossible);
    EXPECT_NE(mold.error().english().find("no room"), std::string::npos);
}

TEST(EjectorHoles, PassThroughOneHalfAndEndAtTheCavity) {
    MoldSettings settings;
    settings.ejectors.count = 2;
    settings.ejectors.diameter = 3;
    const Result<Mold> mold = moldOf(frusta(40, 20, 5, 3, lean), settings);
    expectVerified(mold);
    EXPECT_EQ(count(*mold, "ejector"), 2);
    // The ground of half 2's cavity is flat, 5 mm above the block's face.
    EXPECT_NEAR(mold->otherVolume, 2 * roundArea(3) * 5, 1e-3);
    EXPECT_EQ(diagnose(*mold->half1.mesh).genus, 0);
    EXPECT_EQ(diagnose(*mold->half2.mesh).genus, 2);
    EXPECT_NEAR(mold->cavityVolume, volume(*mold->cast), 1e-9) << "pins are no part of the cast";
    settings.ejectors.side = 1;
    expectVerified(moldOf(frusta(40, 20, 5, 3, lean), settings));
}

TEST(EjectorHoles, FollowTheHalfsDirection) {
    MoldSettings settings = everyFeature();
    settings.ejectors.count = 2;
    settings.ejectors.diameter = 2.5;
    for (const int side : {1, 2})
        for (const int columns : {1, 2}) {
            settings.ejectors.side = side;
            settings.layout.columns = columns;
            const KnownCast cast = moved(sheared(ball(18, 4), 0.35, -0.3), {1, 2, 3}, 0.8, {5, -7, 2});
            const Result<Mold> mold = moldOf(cast, settings);
            expectVerified(mold);
            EXPECT_EQ(count(*mold, "ejector"), 2 * columns);
        }
}

TEST(EjectorHoles, NeedFlatGround) {
    MoldSettings settings;
    settings.ejectors.count = 3;
    settings.ejectors.diameter = 12;
    const Result<Mold> mold = moldOf(ball(10, 4), settings);
    ASSERT_FALSE(mold);
    EXPECT_EQ(mold.error().code, ErrorCode::Impossible);
    EXPECT_NE(mold.error().english().find("0 of 3"), std::string::npos);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
// Molds that lie flat while they are filled: spouts through half 1, and vents upwards.
#include "mesh/check.h"
#include "mesh/measures.h"
#include "support/casts.h"
#include "support/molds.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector3d;

namespace {

MoldSettings lying() {
    MoldSettings settings;
    settings.spout.on = true;
    settings.spout.resting = Resting::Lying;
    settings.spout.diameter = 8;
    settings.spout.neck = 3;
    return settings;
}

/// Volume of a cone's slice, its circles drawn round by polygons of 32 corners.
double slice(double height, double r1, double r2) {
    return 32 * std::tan(std::numbers::pi / 32) * height * (r1 * r1 + r1 * r2 + r2 * r2) / 3;
}

} // namespace

TEST(ThroughSpouts, WidenFromTheirNeckToTheBlocksFace) {
    const Result<Mold> mold = moldOf(frusta(40, 20, 8, 3, 0.1), lying());
    expectVerified(mold);
    EXPECT_EQ(count(*mold, "spout"), 1);
    EXPECT_EQ(diagnose(*mold->half1.mesh).genus, 1);
    EXPECT_EQ(diagnose(*mold->half2.mesh).genus, 0);
    EXPECT_NEAR(volume(*mold->cast), mold->cavityVolume, 1e-9) << "the sprue breaks off: no part of the cast";
    // 5 mm of steel over the cavity: a neck of 1 mm, the cone to the full width, the draft of 5°.
    const double end = 4 + std::tan(radians(5)) * 1.5;
    const double sprue = slice(1, 1.5, 1.7) + slice(2.5, 1.7, 4) + slice(1.5, 4, end);
    EXPECT_NEAR(mold->sprueVolume, sprue, 1e-5 * sprue);
    EXPECT_NEAR(mold->channelVolume, mold->sprueVolume, 1e-9) << "it is mixed and poured all the same";
    ASSERT_FALSE(mold->notes.empty());
    EXPECT_NE(mold->notes.back().english().find("breaks off"), std::string::npos);
}

TEST(ThroughSpouts, ServeEachSolidOfEachCavity) {
    KnownCast cast = frusta(20, 14, 6, 3, 0.1);
    IndexedMesh second = frusta(12, 12, 5, 2, 0.1).mesh;
    second.V.col(0).array() += 22;
    cast.mesh = together(cast.mesh, second);
    MoldSettings settings = lying();
    settings.layout.columns = 2;
    settings.keys.count = 4;
    settings.slits.count = 2;
    const Result<Mold> mold = moldOf(cast, settings);
    expectVerified(mold);
    EXPECT_EQ(count(*mold, "spout"), 4);
    EXPECT_EQ(count(*mold, "runner"), 0);
}

TEST(ThroughSpouts, FollowTheHalfsDirectionWithEveryFeature) {
    MoldSettings settings = lying();
    settings.vents.on = true;
    settings.keys.count = 4;
    settings.slits.count = 2;
    settings.bolts.count = 2;
    settings.ejectors.count = 1;
    settings.ejectors.diameter = 2.5;
    const KnownCast cast = moved(sheared(ball(18, 4), 0.35, -0.3), {1, 2, 3}, 0.8, {5, -7, 2});
    ASSERT_GT(std::acos(cast.state.directions.d1.dot(cast.state.plane.normal)), radians(15));
    for (const int columns : {1, 2}) {
        settings.layout.columns = columns;
        const Result<Mold> mold = moldOf(cast, settings);
        expectVerified(mold);
        EXPECT_EQ(count(*mold, "spout"), columns);
    }
}

TEST(ThroughSpouts, LeaveAirInOtherHillsToVents) {
    KnownCast cast = ring(24, 9, 120, 40);
    for (int v = 0; v < cast.mesh.vertexCount(); ++v)
        cast.mesh.V(v, 2) *= 1 + 0.3 * std::cos(3 * std::atan2(cast.mesh.V(v, 1), cast.mesh.V(v, 0)));
    MoldSettings settings = lying();
    settings.vents.on = true;
    const Result<Mold> mold = moldOf(cast, settings);
    expectVerified(mold);
    EXPECT_EQ(count(*mold, "spout"), 1);
    EXPECT_EQ(count(*mold, "vent"), 2) << "three hills";
    for (const MoldFeature& feature : mold->features)
        if (feature.kind == "vent") {
            EXPECT_NEAR(feature.place.z(), boundingBox(*mold->half1.mesh).max().z(), 1e-5) << "upwards";
        }
}

TEST(ThroughSpouts, MoveVentsToWhereTheyAreNotInTheWay) {
    KnownCast cast = ring(10, 5, 120, 40);
    for (int v = 0; v < cast.mesh.vertexCount(); ++v)
        cast.mesh.V(v, 2) *= 1 + 0.3 * std::cos(3 * std::atan2(cast.mesh.V(v, 1), cast.mesh.V(v, 0)));
    MoldSettings settings = lying();
    settings.vents.on = true;
    settings.vents.smallestTrap = 1;
    const auto highest = [](const Mold& mold) {
        double away = 0;
        for (const MoldFeature& feature : mold.features)
            if (feature.kind == "vent")
                away = std::max(away, feature.stands->place.norm());
        return away;
    };
    const Result<Mold> slender = moldOf(cast, settings);
    expectVerified(slender);
    EXPECT_EQ(count(*slender, "vent"), 2);
    EXPECT_NEAR(highest(*slender), 10, 0.5) << "on the hills";
    settings.spout.diameter = 32; // reaches over the hills beside its own
    const Result<Mold> wide = moldOf(cast, settings);
    expectVerified(wide);
    ASSERT_TRUE(wide);
    EXPECT_EQ(count(*wide, "vent"), 2);
    EXPECT_GT(highest(*wide), 11) << "outwards from the hills";
    for (const ThinSteel& thin : wide->steel)
        if (thin.first == "Vent" || thin.second == "Vent") {
            EXPECT_GE(thin.thickness, settings.leastSteel - 1e-4) << thin.first << ", " << thin.second;
        }
}

TEST(ThroughSpouts, WithoutRoomForTheNeckAreRefused) {
    MoldSettings settings = lying();
    settings.spout.neck = 15;
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, 0.1), settings);
    ASSERT_FALSE(mold);
    EXPECT_EQ(mold.error().code, ErrorCode::Impossible);
    EXPECT_NE(mold.error().english().find("finds no place"), std::string::npos);
}

TEST(ThroughSpouts, ThatMeetAtTheBlocksFaceAreRefusedByName) {
    MoldSettings settings = lying();
    settings.layout.columns = 2;
    settings.layout.spacing = 1;
    settings.spout.diameter = 16;
    settings.ceiling = 30;
    const Result<Mold> mold = moldOf(ball(6, 4), settings);
    ASSERT_FALSE(mold);
    EXPECT_EQ(mold.error().code, ErrorCode::Impossible);
    EXPECT_TRUE(mold.error().english().starts_with("Spout 1 meets the same of the next cavity."))
        << mold.error().english();
    settings.layout.spacing = 12;
    expectVerified(moldOf(ball(6, 4), settings));
}

TEST(Stock, TheNextBlockIsTaken) {
    MoldSettings settings;
    settings.stock = {100, 25, 60};
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, 0.1), settings);
    expectVerified(mold);
    // 20 + 2 · 5 and 10 + 2 · 5; the longer side lies along y.
    EXPECT_NEAR(mold->half1.size.x(), 25, 1e-5);
    EXPECT_NEAR(mold->half1.size.y(), 60, 1e-5);
    settings.stock = {25};
    const Result<Mold> refused = moldOf(frusta(20, 10, 5, 3, 0.1), settings);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Impossible);
    EXPECT_NE(refused.error().english().find("25 mm"), std::string::npos);
}

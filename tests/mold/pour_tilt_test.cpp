// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/pour_tilt.h"

#include "base/parallel.h"
#include "features/drafted_prism.h"
#include "mold/gates.h"
#include "mold/mold_sketch.h"
#include "support/casts.h"
#include "support/molds.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector3d;

namespace {

/// A bar that stands upright with a tower, its right one lower by 3 mm: while its left tower is filled from
/// above, air stays in the right one.
KnownCast towers() {
    PrismRequest request;
    request.base = {{0, 0}, {30, 0}, {30, 17}, {22, 17}, {22, 8}, {8, 8}, {8, 20}, {0, 20}};
    request.height = {3, 3};
    request.directions = {std::vector<Vector3d>{Vector3d::UnitZ()},
                          std::vector<Vector3d>{-Vector3d::UnitZ()}};
    request.grid = 1.0 / 65536;
    return {*prismSolid(draftedPrism(request).value()), {}};
}

/// A mold filled as the towers stand, without what would let the air out.
MoldSettings plain() {
    MoldSettings settings;
    settings.spout.on = true;
    for (const PourDirection pour :
         {PourDirection::Turn0, PourDirection::Turn90, PourDirection::Turn180, PourDirection::Turn270}) {
        settings.spout.pour = pour;
        const Result<Mold> mold = moldOf(towers(), settings);
        if (mold && mold->partToMold.linear().col(1).y() > 0.9)
            return settings;
    }
    ADD_FAILURE() << "both towers never point up";
    return settings;
}

/// With vents too wide to find room beside the spout, or in a tower.
MoldSettings withWideVents() {
    MoldSettings settings = plain();
    settings.vents.on = true;
    settings.vents.diameter = 50;
    return settings;
}

} // namespace

TEST(PourTilt, UpIsWhatLeaningMakesOfIt) {
    for (const Resting resting : {Resting::Standing, Resting::Lying}) {
        const Vector3d upright = resting == Resting::Standing ? Vector3d::UnitY() : Vector3d::UnitZ();
        const Vector3d across = resting == Resting::Standing ? Vector3d::UnitZ() : Vector3d::UnitY();
        EXPECT_EQ(upWhenLeaning(resting, 0, 77), upright);
        const double c = std::cos(radians(20));
        const double s = std::sin(radians(20));
        // A top that leans to the right: what was to its left is up now.
        EXPECT_NEAR((upWhenLeaning(resting, 20, 0) - (c * upright - s * Vector3d::UnitX())).norm(), 0, 1e-12);
        EXPECT_NEAR((upWhenLeaning(resting, 20, 90) - (c * upright - s * across)).norm(), 0, 1e-12);
        EXPECT_NEAR(upWhenLeaning(resting, 20, 45).norm(), 1, 1e-12);
    }
    EXPECT_EQ(leaningWords(Resting::Standing, 270), "half 2");
    EXPECT_EQ(leaningWords(Resting::Standing, -90), "half 2");
    EXPECT_EQ(leaningWords(Resting::Lying, 45), "the back and the right");
    EXPECT_EQ(leaningWords(Resting::Lying, 359), "the right");
}

TEST(PourTilt, IsTheLeastThatLeavesLeastAir) {
    // A bowl about 13° towards 90°, whose bottom is level from 12° to 14°.
    const auto air = [](const PourTilt& tilt) -> Result<double> {
        const Vector3d best(0, 13, 0);
        const Vector3d at(tilt.degrees * std::cos(radians(tilt.towards)),
                          tilt.degrees * std::sin(radians(tilt.towards)), 0);
        return 10 * std::max(0.0, (at - best).norm() - 1);
    };
    const auto found = leastAirTilt(air, 1e-6);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->tilt.degrees, 12);
    EXPECT_EQ(found->tilt.towards, 90);
    EXPECT_NEAR(found->air, 0, 1e-9);
    const auto level = leastAirTilt([](const PourTilt&) -> Result<double> { return 7; }, 1);
    ASSERT_TRUE(level);
    EXPECT_EQ(level->tilt.degrees, 0) << "no reason to lean";
    // Ways that cannot be built are left out.
    const auto half = leastAirTilt(
        [&](const PourTilt& tilt) -> Result<double> {
            if (tilt.towards == 90)
                return failure(ErrorCode::Impossible, MW_TEXT("Mold", "none"));
            return air(tilt);
        },
        1e-6);
    ASSERT_TRUE(half);
    EXPECT_NE(half->tilt.towards, 90);
}

TEST(PourTilt, EmptiesATrapThatFacesAway) {
    const KnownCast cast = towers();
    MoldSettings settings = plain();
    settings.spout.tilt.automatic = true;
    const Result<Mold> mold = moldOf(cast, settings);
    expectVerified(mold);
    ASSERT_TRUE(mold->leaning);
    EXPECT_TRUE(mold->leaning->applied);
    EXPECT_LT(mold->leaning->air, 0.9 * mold->leaning->airUpright);
    EXPECT_LE(mold->leaning->degrees, mostPourTilt);
    // No other way of those tried by hand leaves less.
    for (const double degrees : {6.0, 14.0, 23.0, 30.0})
        for (const double towards : {0.0, 90.0, 180.0, 270.0}) {
            settings.spout.tilt = {false, degrees, towards};
            const Result<Mold> other = moldOf(cast, settings);
            ASSERT_TRUE(other) << other.error().english();
            ASSERT_TRUE(other->leaning);
            EXPECT_NEAR(other->leaning->airUpright, mold->leaning->airUpright, 1e-9);
            EXPECT_GE(other->leaning->air, mold->leaning->air - settings.vents.smallestTrap);
        }
}

TEST(PourTilt, IsSuggestedWhereVentsLeaveAir) {
    MoldSettings settings = withWideVents();
    const Result<Mold> mold = moldOf(towers(), settings);
    expectVerified(mold);
    ASSERT_GT(mold->trappedAir, settings.vents.smallestTrap);
    ASSERT_TRUE(mold->leaning);
    EXPECT_FALSE(mold->leaning->applied);
    EXPECT_NEAR(mold->leaning->airUpright, mold->trappedAir, 1e-6) << "what is built upright";
    const auto told = [](const Mold& of, const std::string& words) {
        return std::ranges::any_of(of.notes,
                                   [&](const Message& note) { return note.english().starts_with(words); });
    };
    EXPECT_TRUE(told(*mold, "Tilt the mold by "));
    settings.spout.tilt = {false, mold->leaning->degrees, mold->leaning->towards};
    const Result<Mold> tilted = moldOf(towers(), settings);
    expectVerified(tilted);
    EXPECT_NEAR(tilted->trappedAir, mold->leaning->air, 1e-6) << "what was promised is what is built";
    EXPECT_TRUE(told(*tilted, "While it is filled the mold is tilted by "));
    settings.spout.tilt = {true, 0, 0};
    const Result<Mold> automatic = moldOf(towers(), settings);
    expectVerified(automatic);
    EXPECT_EQ(automatic->half1.mesh->V, tilted->half1.mesh->V);
    // What is shown while a feature is dragged leans too.
    const KnownCast cast = towers();
    Result<MoldSketcher> sketcher = MoldSketcher::prepared(trayOf(cast), 1, settings);
    ASSERT_TRUE(sketcher);
    EXPECT_NEAR(sketcher->sketch({})->trappedAir, tilted->trappedAir, 1e-9);
}

TEST(PourTilt, ServesTheTiltedMoldAlongObliqueDirections) {
    const KnownCast oblique = moved(sheared(ball(18, 4), 0.35, -0.3), {1, 2, 3}, 0.8, {5, -7, 2});
    for (const Resting resting : {Resting::Standing, Resting::Lying})
        for (const double towards : {0.0, 90.0, 225.0}) {
            MoldSettings settings = everyFeature();
            settings.spout = {true, 4, 6, 3, 5, PourDirection::Automatic, resting, 2, {false, 30, towards}};
            const Result<Mold> mold = moldOf(oblique, settings);
            expectVerified(mold);
            ASSERT_TRUE(mold);
            // Its highest place is off the spout, so air would stay there. Where it is straight behind the
            // spout a vent may have no room.
            if (resting == Resting::Lying || towards != 90)
                EXPECT_GE(count(*mold, "vent"), 1) << towards;
            else
                EXPECT_GE(count(*mold, "vent") + count(*mold, "trapped_air"), 1) << towards;
        }
    MoldSettings steep = plain();
    steep.spout.tilt = {false, 60, 0};
    const Result<Mold> refused = moldOf(towers(), steep);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Usage);
}

TEST(PourTilt, IsTheSameForAnyNumberOfThreads) {
    MoldSettings settings = withWideVents();
    settings.spout.tilt.automatic = true;
    const Result<Mold> many = moldOf(towers(), settings);
    setThreadCount(1);
    const Result<Mold> one = moldOf(towers(), settings);
    setThreadCount(0);
    ASSERT_TRUE(one && many);
    EXPECT_EQ(one->half2.mesh->V, many->half2.mesh->V);
    EXPECT_EQ(one->notes, many->notes);
}

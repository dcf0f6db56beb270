// SPDX-License-Identifier: AGPL-3.0-or-later
// Features that stand where a hand put them.
#include "features/drafted_prism.h"
#include "mold/mold_sketch.h"
#include "support/casts.h"
#include "support/molds.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

const double lean = std::tan(radians(5));

MoldSettings withEverything() {
    MoldSettings settings = everyFeature();
    settings.bolts.count = 2;
    settings.ejectors.count = 2;
    settings.ejectors.diameter = 2.5;
    return settings;
}

/// The features of a kind, by their numbers.
std::vector<const MoldFeature*> ofKind(const std::vector<MoldFeature>& features, Placeable kind) {
    std::vector<const MoldFeature*> found;
    for (const MoldFeature& feature : features)
        if (feature.stands && feature.stands->kind == kind)
            found.push_back(&feature);
    std::ranges::stable_sort(found, {}, [](const MoldFeature* feature) { return feature->stands->number; });
    return found;
}

Vector2d placeOf(const MoldFeature& feature) {
    return feature.place.head<2>();
}

/// Builds with one more feature by hand.
Result<Mold> moldWith(const KnownCast& cast, MoldSettings settings, const PlacedFeature& feature) {
    settings.placed = withPlaced(settings.placed, feature);
    return moldOf(cast, settings);
}

/// That the refusal names all of these.
void expectRefused(const Result<Mold>& mold, const std::vector<std::string>& words) {
    ASSERT_FALSE(mold);
    EXPECT_EQ(mold.error().code, ErrorCode::Impossible);
    for (const std::string& word : words)
        EXPECT_NE(mold.error().english().find(word), std::string::npos) << mold.error().english();
}

/// Square, so that its place in the mold's frame is known: 25 mm from the middle to each side.
KnownCast wide() {
    return frusta(50, 50, 8, 6, lean);
}

/// The thinnest steel between a feature and the cavities.
double toCavity(const Mold& mold, const std::string& name, int number) {
    for (const ThinSteel& thin : mold.steelOfEach)
        if ((thin.first == name && thin.firstNumber == number && thin.second == "Cavity") ||
            (thin.second == name && thin.secondNumber == number && thin.first == "Cavity"))
            return thin.thickness;
    return -1;
}

} // namespace

TEST(PlacedFeatures, KeysBoltsAndSlitsStandWhereTheyArePut) {
    MoldSettings settings;
    settings.keys.count = settings.bolts.count = 4;
    settings.slits.count = 2;
    settings.placed = {
        {Placeable::Key, 1, {36.5, 3}}, {Placeable::Slit, 0, {-1, -12}}, {Placeable::Bolt, 2, {-40.25, 20}}};
    const Result<Mold> mold = moldOf(wide(), settings);
    expectVerified(mold);
    ASSERT_TRUE(mold);
    EXPECT_EQ(placeOf(*ofKind(mold->features, Placeable::Key)[1]), Vector2d(36.5, 3));
    EXPECT_EQ(placeOf(*ofKind(mold->features, Placeable::Bolt)[2]), Vector2d(-40.25, 20));
    const MoldFeature& slit = *ofKind(mold->features, Placeable::Slit)[0];
    EXPECT_EQ(placeOf(slit), Vector2d(boundingBox(*mold->half1.mesh).min().x(), -12));
    EXPECT_TRUE(slit.byHand);
    EXPECT_FALSE(ofKind(mold->features, Placeable::Slit)[1]->byHand);
    for (const ThinSteel& thin : mold->steelOfEach)
        EXPECT_GE(thin.thickness, settings.leastSteel - 1e-4) << thin.first << ", " << thin.second;
}

TEST(PlacedFeatures, TheBlockGrowsToHoldThem) {
    MoldSettings settings;
    settings.bolts.count = 1;
    const double before = moldOf(wide(), settings)->half1.size.x();
    const Result<Mold> mold = moldWith(wide(), settings, {Placeable::Bolt, 0, {70, 0}});
    expectVerified(mold);
    ASSERT_TRUE(mold);
    EXPECT_GT(mold->half1.size.x(), before);
    EXPECT_GE(boundingBox(*mold->half1.mesh).max().x(), 70 + 6.6 / 2 + settings.bolts.wall);
}

TEST(PlacedFeatures, OthersKeepClearOfThem) {
    MoldSettings settings;
    settings.keys.count = 4;
    const Result<Mold> before = moldOf(wide(), settings);
    // The second goes where the third was.
    const Vector2d taken = placeOf(*ofKind(before->features, Placeable::Key)[2]);
    const Result<Mold> mold = moldWith(wide(), settings, {Placeable::Key, 1, taken});
    expectVerified(mold);
    ASSERT_TRUE(mold);
    const auto keys = ofKind(mold->features, Placeable::Key);
    EXPECT_EQ(placeOf(*keys[1]), taken);
    EXPECT_GE((placeOf(*keys[2]) - taken).norm(), settings.keys.diameter + settings.leastSteel);
}

TEST(PlacedFeatures, AKeyMayStandInARingsHole) {
    MoldSettings settings;
    settings.keys.count = 2;
    const KnownCast cast = ring(24, 6, 96, 32);
    const Result<Mold> mold = moldWith(cast, settings, {Placeable::Key, 0, {2, -3}});
    expectVerified(mold);
    ASSERT_TRUE(mold);
    // The ring's inner edge has a radius of 18; the socket of the larger key, one of 3.5 and its clearance.
    const double gap = 18 - Vector2d(2, -3).norm() - 3.5 - settings.keys.clearance;
    EXPECT_NEAR(toCavity(*mold, "Key", 1), gap, 0.15);
}

TEST(PlacedFeatures, WhatStandsInTheWayIsRefusedByName) {
    MoldSettings settings = withEverything();
    settings.keys.count = 2;
    expectRefused(moldWith(wide(), settings, {Placeable::Key, 1, {5, 5}}), {"Key 2", "Cavity 1"});
    expectRefused(moldWith(wide(), settings, {Placeable::Bolt, 0, {25, 0}}), {"Bolt hole 1", "Cavity 1"});
    const Result<Mold> mold = moldOf(wide(), settings);
    const Vector2d spout = ofKind(mold->features, Placeable::Spout).front()->stands->place;
    expectRefused(moldWith(wide(), settings, {Placeable::Key, 0, spout - Vector2d(0, 6)}),
                  {"Key 1", "Spout 1"});
    settings.placed = {{Placeable::Key, 0, {40, 0}}};
    expectRefused(moldWith(wide(), settings, {Placeable::Key, 1, {44, 0}}), {"Key 1", "Key 2"});
    expectRefused(moldWith(wide(), settings, {Placeable::Key, 1, {1e6, 0}}), {"1e+06", "no farther"});
}

TEST(PlacedFeatures, ThinSteelIsBuiltAndTold) {
    MoldSettings settings;
    settings.keys.count = 2;
    // The cavity ends at x = 25 in the plane; the socket's radius is 3 and its clearance.
    const double gap = 0.8;
    const Result<Mold> mold =
        moldWith(wide(), settings, {Placeable::Key, 1, {25 + gap + 3 + settings.keys.clearance, 2}});
    expectVerified(mold);
    ASSERT_TRUE(mold);
    const ThinSteel* thin = thinnestAbout(mold->steelOfEach, Placeable::Key, 1);
    ASSERT_NE(thin, nullptr);
    EXPECT_NEAR(thin->thickness, gap, 0.03);
    EXPECT_EQ(thin->first == "Key" ? thin->second : thin->first, "Cavity");
    EXPECT_LT(thin->thickness, steelAsked(*thin, settings));
    EXPECT_TRUE(std::ranges::any_of(mold->notes, [](const Message& note) {
        return note.english().find("mm of steel between") != std::string::npos;
    }));
}

TEST(PlacedFeatures, TheSpoutMovesAlongItsFace) {
    const MoldSettings settings = everyFeature();
    for (const double x : {-11.0, 0.5, 9.25}) {
        const Result<Mold> mold = moldWith(ball(20, 4), settings, {Placeable::Spout, 0, {x, 0}});
        expectVerified(mold);
        ASSERT_TRUE(mold);
        const MoldFeature& spout = *ofKind(mold->features, Placeable::Spout).front();
        EXPECT_NEAR(spout.stands->place.x(), x, 1e-3);
        EXPECT_NEAR(spout.place.x(), x, 0.1);
        // It leaves the ball's equator at its height there; the higher part drains through vents, if at all.
        EXPECT_LE(mold->trappedAir, std::abs(x) < 1 ? settings.vents.smallestTrap : 1e4);
    }
    expectRefused(moldWith(ball(20, 4), settings, {Placeable::Spout, 0, {25, 0}}),
                  {"x = 25", "from -19.97 to 19.97"});
}

TEST(PlacedFeatures, TheMainRunnerMovesBetweenColumns) {
    MoldSettings settings = everyFeature();
    settings.layout.columns = settings.layout.rows = 2;
    const Result<Mold> before = moldOf(ball(12, 4), settings);
    const double x = ofKind(before->features, Placeable::Spout).front()->stands->place.x();
    const Result<Mold> mold = moldWith(ball(12, 4), settings, {Placeable::Spout, 0, {x + 2, 0}});
    expectVerified(mold);
    ASSERT_TRUE(mold);
    EXPECT_NEAR(ofKind(mold->features, Placeable::Spout).front()->place.x(), x + 2, 1e-3);
    EXPECT_FALSE(moldWith(ball(12, 4), settings, {Placeable::Spout, 0, {x + 16, 0}}));
}

TEST(PlacedFeatures, EjectorPinsStandInEveryCavity) {
    MoldSettings settings;
    settings.layout.columns = 2;
    settings.ejectors.count = 2;
    settings.ejectors.diameter = 3;
    const Result<Mold> mold = moldWith(wide(), settings, {Placeable::Ejector, 1, {-12.5, 6}});
    expectVerified(mold);
    ASSERT_TRUE(mold);
    int there = 0;
    for (const MoldFeature* pin : ofKind(mold->features, Placeable::Ejector))
        there += pin->byHand && pin->stands->place == Vector2d(-12.5, 6) ? 1 : 0;
    EXPECT_EQ(there, 2);
    // At the very edge there is no room for it.
    expectRefused(moldWith(wide(), settings, {Placeable::Ejector, 0, {24.5, 0}}), {"Ejector hole 1", "35°"});
}

TEST(PlacedFeatures, VentsKeepToTheirAir) {
    // Two towers of unlike height on a bar: the lower one traps air when both point up.
    PrismRequest towers;
    towers.base = {{0, 0}, {30, 0}, {30, 20}, {22, 20}, {22, 8}, {8, 8}, {8, 17}, {0, 17}};
    towers.height = {3, 3};
    towers.directions = {std::vector<Vector3d>{Vector3d::UnitZ()}, std::vector<Vector3d>{-Vector3d::UnitZ()}};
    towers.grid = 1.0 / 65536;
    const KnownCast cast{*prismSolid(draftedPrism(towers).value()), {}};
    MoldSettings settings = everyFeature();
    for (const PourDirection pour :
         {PourDirection::Turn0, PourDirection::Turn90, PourDirection::Turn180, PourDirection::Turn270}) {
        settings.spout.pour = pour;
        const Result<Mold> before = moldOf(cast, settings);
        ASSERT_TRUE(before);
        const auto vents = ofKind(before->features, Placeable::Vent);
        if (vents.empty())
            continue;
        const Vector2d stands = vents.front()->stands->place;
        // It stood at a corner of the tower: one way leads along its top, the other off it.
        Vector2d way(1.5, 0);
        if (!moldWith(cast, settings, {Placeable::Vent, 0, stands + way})) {
            expectRefused(moldWith(cast, settings, {Placeable::Vent, 0, stands + way}), {"Vent 1"});
            way.x() = -1.5;
        }
        const Result<Mold> mold = moldWith(cast, settings, {Placeable::Vent, 0, stands + way});
        expectVerified(mold);
        ASSERT_TRUE(mold);
        const MoldFeature& vent = *ofKind(mold->features, Placeable::Vent).front();
        EXPECT_TRUE(vent.byHand);
        EXPECT_NEAR(vent.stands->place.x(), stands.x() + way.x(), 1e-9);
        EXPECT_EQ(mold->trappedAir, 0);
        expectRefused(moldWith(cast, settings, {Placeable::Vent, 0, stands - Vector2d(0, 60)}),
                      {"Vent 1", "beside"});
        return;
    }
    FAIL() << "none of the four traps air";
}

TEST(PlacedFeatures, WhatStandsByItselfStandsThereByHandToo) {
    for (const int columns : {1, 2}) {
        MoldSettings settings = withEverything();
        settings.layout.columns = columns;
        const KnownCast cast = moved(sheared(ball(18, 4), 0.35, -0.3), {1, 2, 3}, 0.8, {5, -7, 2});
        const Result<Mold> found = moldOf(cast, settings);
        expectVerified(found);
        ASSERT_TRUE(found);
        for (const MoldFeature& feature : found->features)
            if (feature.stands)
                settings.placed = withPlaced(settings.placed, *feature.stands);
        EXPECT_GE(settings.placed.size(), 9U);
        const Result<Mold> byHand = moldOf(cast, settings);
        expectVerified(byHand);
        ASSERT_TRUE(byHand);
        ASSERT_EQ(byHand->features.size(), found->features.size());
        for (std::size_t i = 0; i < found->features.size(); ++i)
            EXPECT_EQ(byHand->features[i].place, found->features[i].place) << found->features[i].name;
        EXPECT_TRUE(byHand->half1.mesh->V == found->half1.mesh->V);
        EXPECT_TRUE(byHand->half2.mesh->V == found->half2.mesh->V);
    }
}

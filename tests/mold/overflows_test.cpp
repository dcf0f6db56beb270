// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/overflows.h"

#include "features/drafted_prism.h"
#include "mesh/check.h"
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

MoldSettings withOverflows(int count) {
    MoldSettings settings;
    settings.spout.on = true;
    settings.overflows.count = count;
    return settings;
}

std::vector<const MoldFeature*> overflowsIn(const std::vector<MoldFeature>& features) {
    std::vector<const MoldFeature*> found;
    for (const MoldFeature& feature : features)
        if (feature.kind == "overflow")
            found.push_back(&feature);
    return found;
}

double number(const MoldFeature& feature, const std::string& key) {
    for (const auto& [name, value] : feature.numbers)
        if (name == key)
            return value;
    return std::nan("");
}

double besideSpout(const Mold& mold) {
    for (const MoldFeature& feature : mold.features)
        if (feature.kind == "spout")
            return mold.channelVolume - number(feature, "volume");
    return std::nan("");
}

double steelBetween(const Mold& mold, const std::string& a, const std::string& b) {
    for (const ThinSteel& thin : mold.steel)
        if ((thin.first == a && thin.second == b) || (thin.first == b && thin.second == a))
            return thin.thickness;
    return -1;
}

void expectRefused(const Result<Mold>& mold, const std::string& words) {
    ASSERT_FALSE(mold);
    EXPECT_NE(mold.error().english().find(words), std::string::npos) << mold.error().english();
}

/// Two towers of unlike height on a bar: with both upwards the lower one traps air.
KnownCast towers() {
    PrismRequest request;
    request.base = {{0, 0}, {30, 0}, {30, 20}, {22, 20}, {22, 8}, {8, 8}, {8, 17}, {0, 17}};
    request.height = {3, 3};
    request.directions = {std::vector<Vector3d>{Vector3d::UnitZ()},
                          std::vector<Vector3d>{-Vector3d::UnitZ()}};
    request.grid = 1.0 / 65536;
    return {*prismSolid(draftedPrism(request).value()), {}};
}

} // namespace

TEST(Overflows, HaveTheNumbersCalculatedByHand) {
    MoldSettings settings = withOverflows(1);
    settings.overflows = {1, 8, 2, 3};
    settings.step = 0;
    settings.placed = {{Placeable::Overflow, 0, {1, -10}}}; // in the middle of a short side
    const KnownCast cast = frusta(20, 10, 5, 5, lean);
    const Result<Mold> mold = moldOf(cast, settings);
    expectVerified(mold);
    const auto wells = overflowsIn(mold->features);
    ASSERT_EQ(wells.size(), 1U);
    // On each side an eight-sided frustum, 8 mm across at the plane, 3.2 mm deep, its walls leaning by 5°.
    const double height = 0.4 * 8;
    const double top = 8 - 2 * height * std::tan(radians(5));
    const double well = 2 * 2 * (std::sqrt(2.0) - 1) * height / 3 * (64 + 8 * top + top * top);
    EXPECT_NEAR(number(*wells.front(), "volume"), well, 1e-3);
    // Channel, on each side: 2 mm wide, 3 mm long, 0.8 mm deep, its sides leaning by 5°; of its ends one is
    // in the well's wall, which leans away from it, the other in the cavity's, which does too.
    const double channel = 2 * (2 * 0.8 - 0.64 * std::tan(radians(5))) * (3 + 0.8 * std::tan(radians(5)));
    settings.overflows.count = 0;
    const Result<Mold> without = moldOf(cast, settings);
    ASSERT_TRUE(without);
    // The block is another, and with it the spout's length.
    EXPECT_NEAR(besideSpout(*mold) - besideSpout(*without), well + channel, 0.01 * channel);
    EXPECT_NEAR(steelBetween(*mold, "Cavity", "Overflow"), 3, 0.01) << "as long as the channel";
    EXPECT_GE(steelBetween(*mold, "Overflow", "outside"), settings.wall - 1e-6) << "closed";
    EXPECT_EQ(diagnose(*mold->cast).components, 1);
}

TEST(Overflows, StandWhereMaterialArrivesLast) {
    const Result<Mold> mold = moldOf(ball(12, 4), withOverflows(1));
    expectVerified(mold);
    const auto wells = overflowsIn(mold->features);
    ASSERT_EQ(wells.size(), 1U);
    // A ball is filled from above: farthest is its lowest place.
    const double spout = mold->features[2].stands->place.x();
    EXPECT_NEAR(wells.front()->stands->place.x(), -spout, 0.1);
    EXPECT_NEAR(wells.front()->stands->place.y(), -12, 0.1);
    // Of two more the next are where neither gate nor well are near.
    const Result<Mold> three = moldOf(ball(12, 4), withOverflows(3));
    expectVerified(three);
    ASSERT_EQ(count(*three, "overflow"), 3);
    for (const MoldFeature* well : overflowsIn(three->features))
        if (well->stands->number > 0) {
            EXPECT_NEAR(std::abs(well->stands->place.x()), 12, 1) << well->stands->number;
        }
}

TEST(Overflows, ServeAnAirTrapWithoutAVent) {
    MoldSettings settings = withOverflows(1);
    const auto standsOnTheLowerTower = [&](bool vents) {
        settings.vents.on = vents;
        for (const PourDirection pour :
             {PourDirection::Turn0, PourDirection::Turn90, PourDirection::Turn180, PourDirection::Turn270}) {
            settings.spout.pour = pour;
            const Result<Mold> mold = moldOf(towers(), settings);
            if (!mold || mold->partToMold.linear().col(1).y() < 0.9)
                continue;
            expectVerified(mold);
            const Vector3d middle = overflowsIn(mold->features).front()->place;
            const Vector3d place = mold->partToMold.inverse() * middle;
            return place.y() > 17 && std::abs(place.x() - 4) < 0.1;
        }
        ADD_FAILURE() << "both towers never point up";
        return false;
    };
    EXPECT_TRUE(standsOnTheLowerTower(false));
    EXPECT_FALSE(standsOnTheLowerTower(true)) << "the vent serves it";
}

TEST(Overflows, AreProvedInEveryLayoutAndAlongObliqueDirections) {
    for (const Arrangement arrangement :
         {Arrangement::Grid, Arrangement::Staggered, Arrangement::Packed, Arrangement::Circle}) {
        MoldSettings settings = everyFeature();
        settings.overflows.count = 2;
        settings.layout.rows = settings.layout.columns = 2;
        settings.layout.arrangement = arrangement;
        const Result<Mold> mold = moldOf(frusta(20, 12, 5, 3, lean), settings);
        expectVerified(mold);
        ASSERT_TRUE(mold);
        EXPECT_EQ(count(*mold, "overflow"), 8);
        for (const ThinSteel& thin : mold->steel) {
            if (thin.first.starts_with("Overflow") || thin.second.starts_with("Overflow")) {
                EXPECT_GE(thin.thickness, settings.leastSteel - 1e-6)
                    << thin.first << ", " << thin.second << " in layout " << static_cast<int>(arrangement);
            }
        }
    }
    const KnownCast oblique = moved(sheared(ball(18, 4), 0.35, -0.3), {1, 2, 3}, 0.8, {5, -7, 2});
    for (const Resting resting : {Resting::Standing, Resting::Lying}) {
        MoldSettings settings = everyFeature();
        settings.spout.resting = resting;
        settings.overflows.count = 2;
        settings.layout.columns = 2;
        expectVerified(moldOf(oblique, settings));
    }
    MoldSettings free = withOverflows(2);
    free.layout.arrangement = Arrangement::Free;
    free.layout.places = {{0, 0, 0}, {34, 3, 37}};
    expectVerified(moldOf(frusta(20, 12, 5, 3, lean), free));
    free.layout = {1, 2, Arrangement::Grid, Alternation::Flip, 5};
    expectVerified(moldOf(frusta(20, 12, 5, 3, lean), free));
    MoldSettings flat = withOverflows(1);
    expectVerified(moldOf(frusta(20, 12, 5, 0, lean), flat));
}

TEST(Overflows, KeepClearOfGatesThatAreWiderThanTheCavity) {
    for (const double radius : {3.0, 5.0, 8.0})
        for (const int overflows : {1, 2, 3, 4}) {
            MoldSettings settings = withOverflows(overflows);
            settings.layout.rows = settings.layout.columns = 2;
            settings.spout.gate = 6;
            settings.overflows.diameter = 3;
            const Result<Mold> mold = moldOf(ball(radius, 4), settings);
            if (mold) {
                expectVerified(mold);
                EXPECT_GE(steelBetween(*mold, "Gate", "Overflow"), settings.leastSteel - 1e-3);
            } else
                expectRefused(mold, "There is no room for");
        }
}

TEST(Overflows, StandByHandWhereTheyStandByThemselves) {
    MoldSettings settings = withOverflows(2);
    const KnownCast cast = sheared(ball(15, 4), 0.3, -0.2);
    const Result<Mold> before = moldOf(cast, settings);
    expectVerified(before);
    for (const MoldFeature* well : overflowsIn(before->features))
        settings.placed = withPlaced(settings.placed, *well->stands);
    const Result<Mold> after = moldOf(cast, settings);
    expectVerified(after);
    EXPECT_EQ(before->half1.mesh->V, after->half1.mesh->V);
    EXPECT_EQ(before->half2.mesh->V, after->half2.mesh->V);
    EXPECT_TRUE(overflowsIn(after->features).front()->byHand);
}

TEST(Overflows, GoWhereAHandPutsThem) {
    MoldSettings settings = withOverflows(1);
    const KnownCast cast = ball(15, 4);
    settings.placed = {{Placeable::Overflow, 0, {13, -10}}};
    const Result<Mold> mold = moldOf(cast, settings);
    expectVerified(mold);
    const MoldFeature& well = *overflowsIn(mold->features).front();
    EXPECT_TRUE(well.byHand);
    EXPECT_EQ(well.stands->place, Vector2d(13, -10));
    const Vector2d way = (well.place.head<2>() - well.origin).normalized();
    EXPECT_NEAR(way.dot(Vector2d(13, -10).normalized()), 1, 1e-3) << "it leads straight out there";
    // The sketch that is shown while it is dragged agrees.
    Result<MoldSketcher> sketcher = MoldSketcher::prepared(trayOf(cast), 1, settings);
    ASSERT_TRUE(sketcher);
    const Result<MoldSketch> sketch = sketcher->sketch(settings.placed);
    ASSERT_TRUE(sketch);
    EXPECT_EQ(overflowsIn(sketch->features).front()->outline, well.outline);
    EXPECT_EQ(sketch->steel, mold->steelOfEach);
    settings.placed = {{Placeable::Overflow, 0, {40, 0}}};
    expectRefused(moldOf(cast, settings), "from its cavity's parting line");
    settings.placed = {{Placeable::Overflow, 0, {0, 15}}};
    expectRefused(moldOf(cast, settings), "where the cavity is filled");
}

TEST(Overflows, WithoutRoomOrSpoutAreRefused) {
    MoldSettings settings = withOverflows(8);
    settings.overflows.diameter = 20;
    expectRefused(moldOf(frusta(20, 10, 5, 3, lean), settings), "no room for 8 overflows");
    settings.spout.on = false;
    expectRefused(moldOf(frusta(20, 10, 5, 3, lean), settings), "Overflows need a spout");
}

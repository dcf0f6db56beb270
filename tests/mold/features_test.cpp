// SPDX-License-Identifier: AGPL-3.0-or-later
// Molds with several cavities, channels, keys and slits, on casts whose numbers are known by hand.
#include "base/parallel.h"
#include "features/drafted_prism.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "mold/mold.h"
#include "mold/shrink.h"
#include "support/casts.h"
#include "support/molds.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector3d;

namespace {

const ThinSteel* steelBetween(const Mold& mold, const std::string& a, const std::string& b) {
    for (const ThinSteel& thin : mold.steel)
        if ((thin.first == a && thin.second == b) || (thin.first == b && thin.second == a))
            return &thin;
    return nullptr;
}

/// Volume of a frustum over a × b, height h, lean l.
double frustum(double a, double b, double h, double l) {
    return a * b * h - (a + b) * l * h * h + 4.0 / 3 * l * l * h * h * h;
}

const double lean = std::tan(radians(5));

} // namespace

TEST(MoldFeatures, SeveralCavitiesHaveTheNumbersCalculatedByHand) {
    MoldSettings settings;
    settings.layout = {2, 3, Arrangement::Grid, Alternation::None, 4};
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), settings);
    expectVerified(mold);
    const double cavity = frustum(20, 10, 5, lean) + frustum(20, 10, 3, lean);
    EXPECT_EQ(mold->cavities, 6);
    EXPECT_NEAR(mold->cavityVolume, 6 * cavity, 1e-2);
    EXPECT_NEAR(mold->partingArea, 6 * 200, 1e-3);
    // The part lies with its long side along y: three of 10 mm with 4 between and walls of 5, two of 20.
    EXPECT_NEAR(mold->half1.size.x(), 3 * 10 + 2 * 4 + 2 * 5, 1e-9);
    EXPECT_NEAR(mold->half1.size.y(), 2 * 20 + 4 + 2 * 5, 1e-9);
    EXPECT_NEAR(mold->minWall, 4, 1e-6);
    ASSERT_NE(steelBetween(*mold, "Cavity", "outside"), nullptr);
    EXPECT_NEAR(steelBetween(*mold, "Cavity", "outside")->thickness, 5, 1e-6);
    EXPECT_NEAR(std::abs(mold->clampForce - 12 * 4 / 100.0 * 1.1), 0, 1e-5);
}

TEST(MoldFeatures, HemispheresHaveTheSteelBetweenThem) {
    // The ball's lower half is flattened into a disc in the plane.
    const IndexedMesh whole = ball(10, 5).mesh;
    IndexedMesh dome = whole;
    dome.V.col(2) = dome.V.col(2).cwiseMax(0);
    MoldSettings settings;
    settings.layout = {1, 2, Arrangement::Grid, Alternation::None, 3};
    settings.ceiling = 6;
    const Result<Mold> mold = moldOf({dome, {}}, settings, 0.5);
    expectVerified(mold);
    EXPECT_NEAR(mold->cavityVolume, 2 * 2.0 / 3 * std::numbers::pi * 1000, 0.005 * mold->cavityVolume);
    const double steel = steelBetween(*mold, "Cavity", "Cavity")->thickness;
    EXPECT_GE(steel, 3 - 1e-6);
    EXPECT_LE(steel, 3 + 1.0 / 16) << "cavities stand at sixteenths";
    EXPECT_NEAR(mold->half1.size.z(), 10 + 6, 1e-6);
    EXPECT_NEAR(mold->half2.volume, mold->half2.size.prod(), 1e-6);
}

TEST(MoldFeatures, AllOfThemTogetherAreProved) {
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), everyFeature());
    expectVerified(mold);
    EXPECT_EQ(count(*mold, "spout"), 1);
    EXPECT_EQ(count(*mold, "key"), 4);
    EXPECT_EQ(count(*mold, "slit"), 2);
    EXPECT_GT(mold->channelVolume, 0);
    EXPECT_GE(mold->minWall, mold->settings.leastSteel - 1e-6);
    EXPECT_GT(mold->half2.size.z(), 8 + 3) << "keys stand out of half 2";
}

TEST(MoldFeatures, RunnersFeedAllCavities) {
    MoldSettings settings = everyFeature();
    settings.layout = {3, 4, Arrangement::Grid, Alternation::None, 5};
    const Result<Mold> mold = moldOf(ball(8, 4), settings);
    expectVerified(mold);
    EXPECT_EQ(count(*mold, "gate"), 12);
    EXPECT_EQ(count(*mold, "runner"), 6);
    EXPECT_EQ(mold->pathLengths.size(), 12U);
    EXPECT_EQ(diagnose(*mold->cast).components, 1) << "everything that solidifies is one piece";
    for (const auto& [rows, columns] : {std::pair{3, 4}, std::pair{1, 3}, std::pair{1, 1}}) {
        settings.layout.rows = rows;
        settings.layout.columns = columns;
        const Result<Mold> built = moldOf(ball(8, 4), settings);
        ASSERT_TRUE(built);
        const bool told = std::any_of(built->notes.begin(), built->notes.end(), [](const Message& note) {
            return note.english().find("do not fill at the same time") != std::string::npos;
        });
        EXPECT_EQ(told, columns > 1) << rows << " x " << columns;
    }
}

TEST(MoldFeatures, EachSolidOfAPartHasItsGate) {
    KnownCast cast = frusta(20, 10, 5, 3, lean);
    IndexedMesh second = frusta(8, 6, 4, 2, lean).mesh;
    second.V.col(0).array() += 22;
    cast.mesh = together(cast.mesh, second);
    MoldSettings settings = everyFeature();
    expectVerified(moldOf(cast, settings));
    settings.layout.columns = 2;
    const Result<Mold> mold = moldOf(cast, settings);
    expectVerified(mold);
    EXPECT_EQ(count(*mold, "gate"), 4);
    EXPECT_EQ(diagnose(*mold->cast).components, 1);
}

TEST(MoldFeatures, RunnersKeepTheWallToTheOutside) {
    MoldSettings settings = everyFeature();
    settings.layout = {2, 2, Arrangement::Grid, Alternation::None, 5};
    const Result<Mold> mold = moldOf(ball(8, 4), settings);
    expectVerified(mold);
    EXPECT_GE(steelBetween(*mold, "Runner", "outside")->thickness, settings.wall - 1e-6);
}

TEST(MoldFeatures, OfAFlatBackedPartLeaveTheSecondHalfFlat) {
    MoldSettings settings = everyFeature();
    settings.layout.columns = 2;
    settings.slits.count = 0;
    settings.keys.count = 0;
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 0, lean), settings);
    expectVerified(mold);
    EXPECT_NEAR(mold->half2.volume, mold->half2.size.prod(), 1e-6);
}

TEST(MoldFeatures, FollowObliqueDirections) {
    for (const auto& [s1, s2] : {std::pair{0.35, -0.1}, std::pair{0.3, 0.3}, std::pair{-0.4, 0.27}}) {
        KnownCast cast = sheared(ball(15, 4), s1, s2);
        ASSERT_GT(std::acos(cast.state.directions.d1.z()), radians(15));
        cast = moved(cast, {1, 2, 3}, 0.8, {5, -7, 2});
        MoldSettings settings = everyFeature();
        for (const int columns : {1, 2}) {
            settings.layout.columns = columns;
            settings.layout.rows = columns;
            expectVerified(moldOf(cast, settings));
        }
    }
}

TEST(MoldFeatures, AKeyLeansAsTheDirectionsAsk) {
    // Directions 20° apart: with the 5° asked for it would hold.
    const double half = std::tan(radians(10));
    MoldSettings settings;
    settings.keys.count = 2;
    const Result<Mold> mold = moldOf(sheared(ball(15, 4), half, half), settings);
    expectVerified(mold);
    for (const MoldFeature& feature : mold->features)
        if (feature.kind == "key") {
            EXPECT_FALSE(feature.note.text.empty());
            EXPECT_NEAR(feature.numbers.back().second, 15, 0.2);
        }
}

TEST(MoldFeatures, AKeyThatComesToAPointIsRefusedByName) {
    MoldSettings settings;
    settings.keys.count = 2;
    settings.keys.draft = 44;
    const Result<Mold> mold = moldOf(frusta(40, 30, 5, 3, 0.1), settings);
    ASSERT_FALSE(mold);
    EXPECT_EQ(mold.error().code, ErrorCode::Impossible);
    EXPECT_TRUE(mold.error().english().starts_with("A key 6 mm wide whose walls lean 44°"))
        << mold.error().english();
}

TEST(MoldFeatures, AKeyWithTooLittleLeanWouldHold) {
    // Built as asked for, without the correction: half 1 opened first catches on it.
    const Directions oblique = sheared(ball(15, 4), 0.35, 0.35).state.directions;
    const auto keyAlong = [&](const std::vector<Vector3d>& directions) {
        PrismRequest request;
        request.base = planCircle({0, 0}, 3, 32);
        request.height = {3, 0};
        request.directions[0] = directions;
        request.draftDegrees = 5;
        request.grid = 1.0 / 65536;
        return *prismSolid(draftedPrism(request).value());
    };
    const IndexedMesh corrected = keyAlong({oblique.d1, -oblique.d2});
    const IndexedMesh upright = keyAlong({Vector3d::UnitZ()});
    for (const Vector3d& way : {oblique.d1, Vector3d(-oblique.d2)}) {
        const auto catches = [&](const IndexedMesh& key) {
            int faces = 0;
            for (int f = 0; f < key.faceCount(); ++f)
                faces += doubleAreaVector(key, f).normalized().z() > -0.5 &&
                         doubleAreaVector(key, f).dot(way) <= 0;
            return faces;
        };
        EXPECT_EQ(catches(corrected), 0);
        EXPECT_GT(catches(upright), 0);
    }
}

TEST(MoldFeatures, AChannelIsNeverHalfRound) {
    // Half a circle has no draft at its rim: every wall of spout, runner and gate leans by at least 5°.
    MoldSettings settings = everyFeature();
    settings.layout = {2, 2, Arrangement::Grid, Alternation::None, 5};
    const Result<Mold> mold = moldOf(ball(12, 4), settings);
    expectVerified(mold);
    double steepest = 90;
    const IndexedMesh& cast = *mold->cast;
    for (int f = 0; f < cast.faceCount(); ++f) {
        double low = 1e300;
        double high = -1e300;
        for (int k = 0; k < 3; ++k) {
            low = std::min(low, std::abs(cast.corner(f, k).z()));
            high = std::max(high, std::abs(cast.corner(f, k).z()));
        }
        const Vector3d normal = doubleAreaVector(cast, f).normalized();
        if (low == 0 && high > 0)
            steepest = std::min(steepest, degrees(std::asin(std::abs(normal.z()))));
    }
    EXPECT_GT(steepest, 1) << "the ball's own faces at its equator lean least";
}

TEST(MoldFeatures, OneKeyIsLargerAndAllHaveTheirClearance) {
    MoldSettings settings;
    settings.keys.count = 4;
    settings.keys.clearance = 0.25;
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), settings);
    expectVerified(mold);
    std::vector<double> diameters;
    for (const MoldFeature& feature : mold->features)
        if (feature.kind == "key")
            diameters.push_back(feature.numbers.front().second);
    EXPECT_EQ(diameters, (std::vector<double>{7, 6, 6, 6}));
    // Half 2 stands 3.5 above the plane; the sockets are a clearance deeper.
    EXPECT_NEAR(boundingBox(*mold->half2.mesh).max().z(), 3.5, 1e-5);
    double deepest = 0;
    const IndexedMesh& upper = *mold->half1.mesh;
    for (int v = 0; v < upper.vertexCount(); ++v)
        if (upper.V(v, 2) < 4.5)
            deepest = std::max(deepest, upper.V(v, 2));
    EXPECT_NEAR(deepest, 3.75, 1e-5);
}

TEST(MoldFeatures, TurnedCopiesNeedDirectionsAlongTheNormal) {
    MoldSettings settings;
    settings.layout.columns = 2;
    for (const Alternation alternation : {Alternation::Turn, Alternation::Flip, Alternation::Mirror}) {
        settings.layout.alternation = alternation;
        expectVerified(moldOf(frusta(20, 10, 5, 3, lean), settings));
    }
    settings.layout.alternation = Alternation::Turn;
    const Result<Mold> refused = moldOf(sheared(ball(15, 4), 0.3, -0.3), settings);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Impossible);
    EXPECT_NE(refused.error().english().find("cannot be turned"), std::string::npos);
}

TEST(MoldFeatures, StaggeredAndPackedKeepTheirSpacing) {
    MoldSettings grid;
    grid.layout = {3, 3, Arrangement::Grid, Alternation::None, 4};
    MoldSettings staggered = grid;
    staggered.layout.arrangement = Arrangement::Staggered;
    const Result<Mold> square = moldOf(ball(8, 4), grid);
    const Result<Mold> shifted = moldOf(ball(8, 4), staggered);
    expectVerified(square);
    expectVerified(shifted);
    EXPECT_GE(steelBetween(*shifted, "Cavity", "Cavity")->thickness, 4 - 1e-3);
    EXPECT_LT(shifted->half1.size.y(), square->half1.size.y()) << "rows of balls nest";
    MoldSettings packed = grid;
    packed.layout.arrangement = Arrangement::Packed;
    expectVerified(moldOf(ball(8, 4), packed));
}

TEST(MoldFeatures, AGateIsNeverWiderThanItsCavity) {
    MoldSettings settings = everyFeature();
    for (const double radius : {1.2, 2.0, 2.9})
        for (const int rows : {1, 2}) {
            SCOPED_TRACE(radius);
            settings.layout.rows = settings.layout.columns = rows;
            const Result<Mold> mold = moldOf(ball(radius, 4), settings);
            expectVerified(mold);
            ASSERT_TRUE(mold);
            const auto told = std::ranges::find_if(mold->notes, [](const Message& note) {
                return note.english().find("wider than the cavity") != std::string::npos;
            });
            ASSERT_NE(told, mold->notes.end());
            EXPECT_EQ(told->arguments.front(), "6");
            EXPECT_GE(mold->minWall, settings.leastSteel - 1e-4);
            for (const MoldFeature& feature : mold->features)
                if (feature.kind == "gate") {
                    const double width = feature.numbers.back().second;
                    EXPECT_LT(width, 2 * radius);
                    EXPECT_GT(width, radius);
                }
        }
    const Result<Mold> large = moldOf(ball(5, 4), settings);
    expectVerified(large);
    for (const Message& note : large->notes)
        EXPECT_EQ(note.english().find("wider than the cavity"), std::string::npos);
}

TEST(MoldFeatures, KeysKeepTheirSteelToGatesOfSmallCavities) {
    MoldSettings settings = everyFeature();
    settings.shape = BlockShape::Shell; // keys are drawn inwards
    settings.layout.rows = settings.layout.columns = 2;
    for (const double radius : {2.0, 2.5, 4.0})
        for (const int keys : {4, 8}) {
            settings.keys.count = keys;
            const Result<Mold> mold = moldOf(ball(radius, 4), settings);
            expectVerified(mold);
            ASSERT_TRUE(mold);
            for (const ThinSteel& thin : mold->steel)
                if (thin.first == "Key" || thin.second == "Key") {
                    EXPECT_GE(thin.thickness, settings.leastSteel - 1e-4)
                        << thin.first << ", " << thin.second;
                }
        }
}

TEST(MoldFeatures, KeysAreSpreadWhereTheBlockHasRoom) {
    MoldSettings settings;
    settings.wall = 14;
    for (const int keys : {3, 4}) {
        settings.keys.count = keys;
        const Result<Mold> mold = moldOf(frusta(200, 20, 6, 6, lean), settings);
        expectVerified(mold);
        std::vector<Vector3d> places;
        for (const MoldFeature& feature : mold->features)
            if (feature.kind == "key")
                places.push_back(feature.place);
        ASSERT_EQ(places.size(), static_cast<std::size_t>(keys));
        for (std::size_t i = 0; i < places.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_GT((places[i] - places[j]).norm(), keys == 3 ? 80 : 45);
    }
}

TEST(MoldFeatures, AreTheSameForAnyNumberOfThreads) {
    MoldSettings settings = everyFeature();
    settings.layout.columns = 2;
    std::vector<Mold> molds;
    for (const int threads : {1, 1, 2, 3}) {
        setThreadCount(threads);
        molds.push_back(moldOf(sheared(ball(15, 4), 0.3, -0.1), settings).value());
    }
    setThreadCount(0);
    for (const Mold& mold : molds) {
        EXPECT_EQ(molds[0].half1.mesh->V, mold.half1.mesh->V);
        EXPECT_EQ(molds[0].half2.mesh->F, mold.half2.mesh->F);
        EXPECT_EQ(molds[0].cast->F, mold.cast->F);
        EXPECT_EQ(molds[0].minWallPlace, mold.minWallPlace);
    }
}

TEST(Shrink, FormulasAreThoseOfTheTrade) {
    EXPECT_DOUBLE_EQ(shrinkFactor(5, ShrinkFormula::Plus), 1.05);
    EXPECT_NEAR(shrinkFactor(5, ShrinkFormula::Divide), 1.0526315789, 1e-9);
    EXPECT_LT(shrinkFactor(-0.2, ShrinkFormula::Plus), 1);
}

TEST(Shrink, MakesTheCavityLarger) {
    MoldSettings settings;
    settings.shrink.percent.setConstant(2);
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), settings);
    expectVerified(mold);
    const double part = frustum(20, 10, 5, lean) + frustum(20, 10, 3, lean);
    EXPECT_NEAR(mold->cavityVolume, part * std::pow(1.02, 3), 1e-5 * part);
    EXPECT_NEAR(mold->partingArea, 200 * 1.02 * 1.02, 1e-3);
}

TEST(Shrink, AlongTheAxesTurnsPlaneAndDirections) {
    KnownCast cast = moved(frusta(20, 10, 5, 3, std::tan(radians(8))), {0, 1, 0}, 0.6, {3, 2, 1});
    ShrinkSettings shrink;
    shrink.percent = Vector3d(1, 2, 4);
    shrink.origin = Vector3d(3, 2, 1);
    const Result<CompensatedCast> larger = compensated(cast.mesh, cast.state, shrink);
    ASSERT_TRUE(larger);
    // Points of the old plane lie in the new one.
    const SideLabels labels = labelSides(cast.mesh, cast.state.plane);
    EXPECT_EQ(labelSides(larger->mesh, larger->state.plane), labels);
    EXPECT_NEAR(volume(larger->mesh), volume(cast.mesh) * 1.01 * 1.02 * 1.04, 1e-2);
    MoldSettings settings;
    settings.shrink = shrink;
    expectVerified(moldOf(cast, settings));
}

TEST(Shrink, ThatTakesTheDraftSaysByHowMuch) {
    const KnownCast cast = frusta(20, 10, 5, 3, std::tan(radians(1.05)));
    MoldSettings settings;
    settings.shrink.percent = Vector3d(0, 0, 6);
    const Result<Mold> mold = moldOf(cast, settings);
    ASSERT_TRUE(mold);
    EXPECT_FALSE(mold->verified());
    ASSERT_FALSE(mold->notes.empty());
    EXPECT_NE(mold->notes.front().english().find("Design the cast with"), std::string::npos);
}

TEST(Shrink, OfHalfThePartIsAMistake) {
    MoldSettings settings;
    settings.shrink.percent.setConstant(60);
    ASSERT_FALSE(moldOf(frusta(20, 10, 5, 3, lean), settings));
}

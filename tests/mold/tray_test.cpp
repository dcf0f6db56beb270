// SPDX-License-Identifier: AGPL-3.0-or-later
// Different parts in one mold: where they stand, whether they may, and that all numbers are theirs.
#include "mold/tray.h"

#include "mesh/check.h"
#include "mold/mold_files.h"
#include "mold/mold_sketch.h"
#include "support/casts.h"
#include "support/molds.h"
#include "support/shapes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector3d;
using Json = nlohmann::ordered_json;

namespace {

const double lean = std::tan(radians(5));

TrayPart part(const KnownCast& cast, const std::string& name, int count = 1) {
    TrayPart one = test::trayOf(cast).front();
    one.name = name;
    one.count = count;
    return one;
}

/// A bar and a smaller ball.
Tray barAndBall(int bars = 1, int balls = 1) {
    return {part(frusta(30, 16, 5, 3, lean), "bar", bars), part(ball(7, 4), "ball", balls)};
}

KnownCast turnedBall(double tilt, double azimuth) {
    return moved(sheared(ball(12, 4), tilt, tilt), Vector3d::UnitZ(), azimuth, {3, 4, 5});
}

MoldSettings arranged(Arrangement arrangement, int rows, int columns) {
    MoldSettings settings = everyFeature();
    settings.overflows.count = 1;
    settings.layout.arrangement = arrangement;
    settings.layout.rows = rows;
    settings.layout.columns = columns;
    return settings;
}

std::vector<std::size_t> partsAt(const Tray& tray, int rows, int columns) {
    LayoutSettings layout;
    layout.rows = rows;
    layout.columns = columns;
    return seated(tray, layout).value().partAt;
}

std::vector<const MoldFeature*> cavitiesOf(const Mold& mold, const std::string& name) {
    std::vector<const MoldFeature*> cavities;
    for (const MoldFeature& feature : mold.features)
        if (feature.kind == "cavity" && feature.part == name)
            cavities.push_back(&feature);
    return cavities;
}

/// The points of the part, made larger and moved by its motion, are the cast's but for those in channels.
void expectLeadsOntoItsCavity(const Mold& mold, std::size_t number, const TrayPart& part) {
    const IndexedMesh& mesh = *part.cast->mesh;
    int found = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vector3d p = mold.parts[number].toMold * mold.shrinkFactors.cwiseProduct(mesh.point(v));
        found += (mold.cast->V.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff() < 1e-6 ? 1 : 0;
    }
    EXPECT_GT(found, 0.7 * mesh.vertexCount()) << part.name;
}

void expectRefused(const Tray& tray, const MoldSettings& settings, ErrorCode code,
                   const std::vector<std::string>& words) {
    const Result<Mold> mold = buildMold(tray, 1, settings);
    ASSERT_FALSE(mold);
    EXPECT_EQ(mold.error().code, code);
    for (const std::string& word : words)
        EXPECT_NE(mold.error().english().find(word), std::string::npos) << mold.error().english();
}

} // namespace

TEST(Tray, FirstPartTakesThePlacesThatTheOthersLeave) {
    EXPECT_EQ(partsAt(barAndBall(1, 2), 2, 3), (std::vector<std::size_t>{0, 0, 0, 0, 1, 1}));
    EXPECT_EQ(partsAt(barAndBall(1, 3), 2, 2), (std::vector<std::size_t>{0, 1, 1, 1}));
    const Tray three = {part(ball(5, 3), "a"), part(ball(5, 3), "b", 2), part(ball(5, 3), "c")};
    EXPECT_EQ(partsAt(three, 1, 5), (std::vector<std::size_t>{0, 0, 1, 1, 2}));
}

TEST(Tray, RowsThatAreTooShortGetMoreColumns) {
    EXPECT_EQ(partsAt(barAndBall(1, 3), 1, 1), (std::vector<std::size_t>{0, 1, 1, 1}));
    EXPECT_EQ(partsAt(barAndBall(1, 4), 2, 2), (std::vector<std::size_t>{0, 0, 1, 1, 1, 1}));
    const Result<Mold> mold = buildMold(barAndBall(1, 4), 1, arranged(Arrangement::Grid, 2, 2));
    expectVerified(mold);
    EXPECT_EQ(mold->cavities, 6);
    EXPECT_TRUE(std::ranges::any_of(mold->notes, [](const Message& note) {
        return note.english().find("2 × 3 cavities instead of 2 × 2") != std::string::npos;
    }));
    EXPECT_EQ(mold->settings.layout.columns, 2) << "what was asked for stays";
}

TEST(Tray, FreeLayoutHasThePlacesThatItHas) {
    MoldSettings settings = arranged(Arrangement::Free, 1, 1);
    settings.layout.places = {{0, 0, 0}, {40, 0, 0}};
    expectRefused(barAndBall(1, 2), settings, ErrorCode::Usage, {"2 places", "ask for 3"});
    settings.layout.places.push_back({75, 2, 90});
    const Result<Mold> mold = buildMold(barAndBall(1, 2), 1, settings);
    expectVerified(mold);
    EXPECT_EQ(mold->parts[1].cavities, 2);
    EXPECT_EQ(count(*mold, "spout"), 3);
    expectLeadsOntoItsCavity(*mold, 0, barAndBall()[0]);
    expectRefused(barAndBall(1, 0), settings, ErrorCode::Usage, {"0 cavities of ball"});
    expectRefused(barAndBall(1, 2'000'000'000), settings, ErrorCode::Usage, {"1 to 400"});
}

TEST(Tray, IsProvedInEveryArrangementWithEveryFeature) {
    for (const Arrangement arrangement :
         {Arrangement::Grid, Arrangement::Staggered, Arrangement::Packed, Arrangement::Circle})
        for (const Resting resting : {Resting::Standing, Resting::Lying}) {
            SCOPED_TRACE(static_cast<int>(arrangement));
            MoldSettings settings = arranged(arrangement, 2, 3);
            settings.spout.resting = resting;
            settings.ejectors.count = 1;
            settings.ejectors.diameter = 2;
            settings.shrink.percent.setConstant(2);
            const Tray tray = barAndBall(1, 3);
            const Result<Mold> mold = buildMold(tray, 1, settings);
            expectVerified(mold);
            ASSERT_TRUE(mold);
            ASSERT_EQ(mold->parts.size(), 2U);
            EXPECT_EQ(mold->parts[0].cavities, 3);
            EXPECT_EQ(mold->parts[1].cavities, 3);
            for (std::size_t number = 0; number < 2; ++number) {
                EXPECT_NEAR(mold->parts[number].volume, volume(*tray[number].cast->mesh) * std::pow(1.02, 3),
                            1e-4 * mold->parts[number].volume);
                expectLeadsOntoItsCavity(*mold, number, tray[number]);
            }
            EXPECT_EQ(mold->partToMold.matrix(), mold->parts[0].toMold.matrix());
            EXPECT_NEAR(mold->cavityVolume, 3 * (mold->parts[0].volume + mold->parts[1].volume),
                        1e-4 * mold->cavityVolume);
            EXPECT_EQ(count(*mold, "overflow"), 6);
            EXPECT_EQ(count(*mold, "ejector"), 6);
            EXPECT_GE(mold->minWall, settings.leastSteel - 1e-6);
            EXPECT_EQ(cavitiesOf(*mold, "ball").size(), 3U);
            EXPECT_EQ(cavitiesOf(*mold, "ball").front()->number, 4);
        }
}

TEST(Tray, PackedHasAPitchOfItsOwnForEachColumnAndRow) {
    const double spacing = 5;
    for (const bool inARow : {true, false}) {
        MoldSettings settings;
        settings.layout.arrangement = Arrangement::Packed;
        (inARow ? settings.layout.columns : settings.layout.rows) = 4;
        const Result<Mold> mold = buildMold(barAndBall(2, 2), 1, settings);
        expectVerified(mold);
        ASSERT_TRUE(mold);
        std::vector<double> places;
        for (const std::string name : {"bar", "ball"})
            for (const MoldFeature* cavity : cavitiesOf(*mold, name))
                places.push_back(inARow ? cavity->place.x() : cavity->place.y());
        const double bar = inARow ? 16 : 30; // it lies with its longer side along y
        const double ball = 14;
        EXPECT_NEAR(places[1] - places[0], bar + spacing, 0.1);
        EXPECT_NEAR(places[2] - places[1], (bar + ball) / 2 + spacing, 0.2);
        EXPECT_NEAR(places[3] - places[2], ball + spacing, 0.2);
        EXPECT_GE(mold->minWall, spacing - 0.01);
    }
}

TEST(Tray, PackedLeavesTheMainRunnerItsRoom) {
    for (const int columns : {1, 2, 3, 4}) {
        SCOPED_TRACE(columns);
        const Result<Mold> mold = buildMold(barAndBall(1, 4), 1, arranged(Arrangement::Packed, 2, columns));
        expectVerified(mold);
        ASSERT_TRUE(mold);
        EXPECT_GE(mold->minWall, mold->settings.leastSteel - 1e-6);
        for (const ThinSteel& thin : mold->steel)
            if (thin.first == "Cavity" && thin.second == "Cavity") {
                EXPECT_GE(thin.thickness, mold->settings.layout.spacing - 0.01);
            }
    }
}

TEST(Tray, HangsSmallPartsAsNearToTheRunnerAsLargeOnes) {
    MoldSettings settings = everyFeature();
    settings.vents.on = false;
    settings.layout.columns = 2;
    const Tray tray = {part(frusta(32, 32, 5, 3, lean), "slab"), part(ball(7, 4), "ball")};
    const Result<Mold> mold = buildMold(tray, 1, settings);
    expectVerified(mold);
    ASSERT_TRUE(mold);
    const double slab = cavitiesOf(*mold, "slab").front()->place.y() + 16;
    const double ball = cavitiesOf(*mold, "ball").front()->place.y() + 7;
    EXPECT_NEAR(slab, ball, 0.1);
}

TEST(Tray, IsFilledOverWaysOfOneLengthByBalancedRunners) {
    MoldSettings settings = arranged(Arrangement::Grid, 2, 2);
    settings.spout.runners = Runners::Balanced;
    const Result<Mold> mold = buildMold(barAndBall(2, 2), 1, settings);
    ASSERT_TRUE(mold) << mold.error().english();
    EXPECT_TRUE(mold->verified());
    ASSERT_EQ(mold->pathLengths.size(), 4U);
    const auto [least, most] = std::ranges::minmax(mold->pathLengths);
    EXPECT_NEAR(least, most, 1e-9);
    // One bar and a ball fit in a row of one place each: what the tray asks for counts, not the settings.
    settings.layout.rows = settings.layout.columns = 1;
    const Result<Mold> row = buildMold(barAndBall(), 1, settings);
    ASSERT_TRUE(row) << row.error().english();
    EXPECT_NEAR(row->pathLengths.front(), row->pathLengths.back(), 1e-9);
}

TEST(Tray, NamesEachCavityByItsPart) {
    const Result<Mold> mold = buildMold(barAndBall(1, 2), 1, {});
    expectVerified(mold);
    const Json json = Json::parse(moldJson(*mold));
    std::vector<std::string> names;
    for (const Json& feature : json["features"])
        if (feature["kind"] == "cavity")
            names.push_back(feature["name"]);
    EXPECT_EQ(names, (std::vector<std::string>{"Cavity 1 (bar)", "Cavity 2 (ball)", "Cavity 3 (ball)"}));
    EXPECT_EQ(json["parts"][1]["cavities"], 2);
    EXPECT_EQ(json["parts"][0]["part_to_mold"], json["part_to_mold"]);
    const Json alone = Json::parse(moldJson(*moldOf(ball(6, 4), {})));
    EXPECT_EQ(alone["features"][1]["name"], "Cavity");
}

TEST(Tray, HollowPartsHaveWallsOfTheirOwn) {
    MoldSettings settings;
    settings.hollow.wall = 1;
    settings.density = 2;
    const Result<Mold> mold = buildMold(barAndBall(1, 2), 1, settings);
    expectVerified(mold);
    const auto& parts = mold->parts;
    EXPECT_NEAR(parts[1].shellVolume / parts[1].volume, 1 - std::pow(6.0 / 7, 3), 0.01);
    EXPECT_NEAR(mold->shellVolume, parts[0].shellVolume + 2 * parts[1].shellVolume, 1e-9);
    const Json json = Json::parse(moldJson(*mold));
    EXPECT_NEAR(json["parts"][1]["mass_each_g"].get<double>(), parts[1].shellVolume / 1000 * 2, 1e-12);
    EXPECT_FALSE(json["shot"]["hollow"].contains("mass_each_g"));
}

TEST(Tray, TurnsAPartUntilItLeavesAlongTheMoldsDirections) {
    // 19° off the normal, the second part turned by 90°: as it lies it would hang in its cavity.
    const Tray tray = {part(turnedBall(0.35, 0), "first"), part(turnedBall(0.35, radians(90)), "other")};
    for (const Arrangement arrangement : {Arrangement::Grid, Arrangement::Packed, Arrangement::Circle}) {
        MoldSettings settings = arranged(arrangement, 1, 3);
        settings.spout.pour = PourDirection::Turn0;
        const Result<Mold> mold = buildMold(tray, 1, settings);
        expectVerified(mold);
        ASSERT_TRUE(mold);
        expectLeadsOntoItsCavity(*mold, 1, tray[1]);
        const Vector3d own = mold->parts[1].toMold.linear() * tray[1].cast->state.directions.d1;
        EXPECT_LT((own - mold->directions.d1).norm(), 0.02);
    }
}

TEST(Tray, RefusesAPartThatCannotLeaveWithTheDraftItWouldHave) {
    Tray tray = {part(turnedBall(0.35, 0), "first"), part(turnedBall(-0.05, 0), "steep")};
    tray[1].source = "designs/steep";
    expectRefused(tray, {}, ErrorCode::Impossible, {"steep (designs/steep)", "1° are required"});
    // Of 3° walls, in a mold that asks for 4°.
    const Tray upright = {part(frusta(30, 16, 5, 3, lean), "bar"),
                          part(frusta(20, 10, 5, 3, std::tan(radians(3))), "flat")};
    const Result<Mold> refused = buildMold(upright, 4, {});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().english().find("flat cannot"), std::string::npos) << refused.error().english();
    EXPECT_NE(refused.error().english().find(" 3° at best"), std::string::npos) << refused.error().english();
    expectVerified(buildMold(upright, 2.9, {}));
}

TEST(Tray, RefusesWhatIsNoFinishedCast) {
    IndexedMesh crossing = together(ball(6, 3).mesh, ball(6, 3).mesh);
    crossing.V.bottomRows(crossing.V.rows() / 2).col(0).array() += 5;
    expectRefused({part(ball(6, 3), "first"), part({crossing, {}}, "two")}, {}, ErrorCode::BadInput, {"two"});
}

TEST(Tray, HasNoAlternation) {
    MoldSettings settings;
    settings.layout.columns = 2;
    settings.layout.alternation = Alternation::Turn;
    expectRefused(barAndBall(), settings, ErrorCode::Usage, {"of one part"});
}

TEST(Tray, HasChannelsWhereAllPartsHaveDepth) {
    const Tray tray = {part(ball(8, 4), "ball"), part(frusta(20, 10, 6, 0, lean), "flat-backed")};
    const Result<Mold> mold = buildMold(tray, 1, everyFeature());
    expectVerified(mold);
    for (const MoldFeature& feature : mold->features)
        if (feature.kind == "spout") {
            EXPECT_EQ(feature.numbers[2], (std::pair<std::string, double>{"height_2", 0}));
        }
}

TEST(Tray, IsSketchedAsItIsBuilt) {
    MoldSettings settings = arranged(Arrangement::Packed, 1, 4);
    const Tray tray = barAndBall(1, 2);
    const Result<Mold> mold = buildMold(tray, 1, settings);
    expectVerified(mold);
    Result<MoldSketcher> sketcher = MoldSketcher::prepared(tray, 1, settings);
    ASSERT_TRUE(sketcher);
    const Result<MoldSketch> sketch = sketcher->sketch({});
    ASSERT_TRUE(sketch);
    EXPECT_EQ(sketch->steel, mold->steelOfEach);
    EXPECT_EQ(sketch->partToMold.matrix(), mold->partToMold.matrix());
    EXPECT_EQ(blockSize(tray, 1, settings).value(), mold->blockSize);
}

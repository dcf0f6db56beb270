// SPDX-License-Identifier: AGPL-3.0-or-later
// Cavities on a circle about a star of runners, and cavities wherever they were put.
#include "mesh/check.h"
#include "mesh/measures.h"
#include "mold/circle_layout.h"
#include "support/casts.h"
#include "support/molds.h"
#include "support/shapes.h"

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

std::vector<Vector2d> cavityPlaces(const Mold& mold) {
    std::vector<Vector2d> places;
    for (const MoldFeature& feature : mold.features)
        if (feature.kind == "cavity")
            places.emplace_back(feature.place.head<2>());
    return places;
}

double steelBetweenCavities(const Mold& mold) {
    for (const ThinSteel& thin : mold.steel)
        if (thin.first == "Cavity" && thin.second == "Cavity")
            return thin.thickness;
    return 0;
}

MoldSettings circleOf(int count) {
    MoldSettings settings = everyFeature();
    settings.layout.arrangement = Arrangement::Circle;
    settings.layout.columns = count;
    return settings;
}

} // namespace

TEST(GridLayout, HoldsAWideFunnelBesideOneColumn) {
    MoldSettings settings;
    settings.spout.on = true;
    settings.layout.rows = 2;
    for (const double funnel : {12.0, 30.0, 50.0}) {
        settings.spout.funnel = funnel;
        const Result<Mold> mold = moldOf(frusta(40, 12, 6, 4, lean), settings);
        expectVerified(mold);
        ASSERT_TRUE(mold);
        EXPECT_GE(mold->blockSize.x(), funnel + 2 * settings.leastSteel);
    }
}

TEST(CircleLayout, FillsAllCavitiesOverWaysOfOneLength) {
    for (const int cavities : {2, 3, 5, 8}) {
        const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), circleOf(cavities));
        expectVerified(mold);
        EXPECT_EQ(mold->cavities, cavities);
        EXPECT_EQ(count(*mold, "gate"), cavities);
        EXPECT_EQ(diagnose(*mold->cast).components, 1) << "everything that solidifies is one piece";
        ASSERT_EQ(mold->pathLengths.size(), static_cast<std::size_t>(cavities));
        const auto [least, most] = std::minmax_element(mold->pathLengths.begin(), mold->pathLengths.end());
        EXPECT_NEAR(*least, *most, 0.01);
        EXPECT_GE(mold->minWall, mold->settings.leastSteel - 1e-6);
    }
}

TEST(CircleLayout, StandsOnACircleWithTurnedCopies) {
    MoldSettings settings = circleOf(6);
    settings.spout.on = settings.vents.on = false;
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), settings);
    expectVerified(mold);
    const std::vector<Vector2d> places = cavityPlaces(*mold);
    ASSERT_EQ(places.size(), 6U);
    Vector2d middle = Vector2d::Zero();
    for (const Vector2d& place : places)
        middle += place / 6;
    const double radius = (places[0] - middle).norm();
    for (const Vector2d& place : places)
        EXPECT_NEAR((place - middle).norm(), radius, 0.01);
    // part_to_mold leads onto the first of them, turn and all.
    const KnownCast cast = frusta(20, 10, 5, 3, lean);
    for (int v = 0; v < cast.mesh.vertexCount(); ++v) {
        const Vector3d p = mold->partToMold * cast.mesh.point(v);
        EXPECT_LT((mold->cast->V.rowwise() - p.transpose()).rowwise().norm().minCoeff(), 1e-3);
    }
    // Turned, all look alike from the middle, so all neighbours are as near to each other.
    EXPECT_NEAR(steelBetweenCavities(*mold), settings.layout.spacing, 0.3);
}

TEST(CircleLayout, MovesCopiesWhereTheDirectionsForbidATurn) {
    // 19° off the normal: turned by 60° the balls would hang in their cavities.
    const KnownCast cast = sheared(ball(12, 4), 0.35, 0.35);
    const Result<Mold> mold = moldOf(cast, circleOf(6));
    expectVerified(mold);
    const auto [least, most] = std::minmax_element(mold->pathLengths.begin(), mold->pathLengths.end());
    EXPECT_NEAR(*least, *most, 0.01);
    std::vector<CavityKind> kinds = kindsRound({cavityKind(cast.mesh, labelSides(cast.mesh, {}))},
                                               {0, 0, 0, 0, 0, 0}, {cast.state.directions, 1, 1.0 / 65536});
    for (const CavityKind& kind : kinds)
        EXPECT_EQ(kind.cast.V, cast.mesh.V);
    const KnownCast upright = ball(12, 4);
    kinds = kindsRound({cavityKind(upright.mesh, labelSides(upright.mesh, {}))}, {0, 0, 0, 0, 0, 0},
                       {upright.state.directions, 1, 1.0 / 65536});
    EXPECT_NE(kinds[0].cast.V, kinds[1].cast.V);
    for (const CavityKind& kind : kinds)
        EXPECT_NEAR(kind.inlet.norm(), 1, 1e-12);
}

TEST(CircleLayout, KeepsItsSteelAboutLongGates) {
    // Copies that are only moved: the way from some cavities to their arm is long.
    MoldSettings settings = circleOf(6);
    settings.shape = BlockShape::Shell; // keys are drawn inwards
    settings.keys.count = 12;
    for (const double length : {15.0, 20.0, 60.0})
        for (const double spout : {8.0, 16.0}) {
            settings.spout.diameter = spout;
            const Result<Mold> mold = moldOf(sheared(frusta(length, 12, 6, 4, lean), 0.3, -0.25), settings);
            expectVerified(mold);
            ASSERT_TRUE(mold);
            for (const ThinSteel& thin : mold->steelOfEach)
                EXPECT_GE(thin.thickness, settings.leastSteel - 1e-3) << thin.first << ' ' << thin.second;
        }
}

TEST(CircleLayout, OfSeveralSolidsIsNotFilledFromTheMiddle) {
    KnownCast cast = frusta(20, 10, 5, 3, lean);
    IndexedMesh second = frusta(8, 6, 4, 2, lean).mesh;
    second.V.col(0).array() += 22;
    cast.mesh = together(cast.mesh, second);
    MoldSettings settings = circleOf(4);
    const Result<Mold> mold = moldOf(cast, settings);
    ASSERT_FALSE(mold);
    EXPECT_EQ(mold.error().code, ErrorCode::Impossible);
    settings.spout.resting = Resting::Lying;
    expectVerified(moldOf(cast, settings));
}

TEST(FreeLayout, PutsEachCavityWhereItIsWanted) {
    MoldSettings settings = everyFeature();
    settings.layout.arrangement = Arrangement::Free;
    settings.layout.places = {{0, 0, 0}, {40, 5, 90}, {80, -3, 30}};
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), settings);
    expectVerified(mold);
    const std::vector<Vector2d> places = cavityPlaces(*mold);
    ASSERT_EQ(places.size(), 3U);
    EXPECT_NEAR((places[1] - places[0] - Vector2d(40, 5)).norm(), 0, 0.01);
    EXPECT_NEAR((places[2] - places[0] - Vector2d(80, -3)).norm(), 0, 0.01);
    EXPECT_EQ(count(*mold, "spout"), 3) << "each has a spout of its own";
}

TEST(FreeLayout, RefusesCavitiesThatAreTooNear) {
    MoldSettings settings;
    settings.layout.arrangement = Arrangement::Free;
    settings.layout.places = {{0, 0, 0}, {10.5, 0, 0}};
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), settings);
    ASSERT_FALSE(mold);
    EXPECT_EQ(mold.error().code, ErrorCode::Impossible);
    EXPECT_NE(mold.error().english().find("0.5"), std::string::npos) << mold.error().english();
}

TEST(FreeLayout, RefusesATurnThatTheDirectionsForbid) {
    MoldSettings settings;
    settings.layout.arrangement = Arrangement::Free;
    settings.layout.places = {{0, 0, 0}, {60, 0, 90}};
    const Result<Mold> mold = moldOf(sheared(ball(12, 4), 0.35, 0.35), settings);
    ASSERT_FALSE(mold);
    EXPECT_EQ(mold.error().code, ErrorCode::Impossible);
    settings.layout.places[1].turn = 0;
    expectVerified(moldOf(sheared(ball(12, 4), 0.35, 0.35), settings));
}

TEST(FreeLayout, RefusesASpoutThroughAnotherCavity) {
    MoldSettings settings = everyFeature();
    settings.layout.arrangement = Arrangement::Free;
    settings.layout.places = {{0, 0, 0}, {2, 40, 0}};
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), settings);
    ASSERT_FALSE(mold);
    EXPECT_EQ(mold.error().code, ErrorCode::Impossible);
    settings.spout.resting = Resting::Lying;
    expectVerified(moldOf(frusta(20, 10, 5, 3, lean), settings));
}

// SPDX-License-Identifier: AGPL-3.0-or-later
// Undercuts that the designer has filled or bent, one by one.
#include "design/filling.h"

#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace moldwright;

namespace {

using Treatment = UndercutChoice::Treatment;

const MoldState level{{Eigen::Vector3d::UnitZ(), 0}, {}};

/// A ring that stands about (x, 0, 3) and dips into the plane: its hole is an obstruction of side 1.
IndexedMesh standingRing(double x) {
    IndexedMesh ring =
        test::rotated(test::torus(4, 1.2, 40, 20), Eigen::Vector3d::UnitX(), std::numbers::pi / 2);
    ring.V.rowwise() += Eigen::RowVector3d(x, 0, 4);
    return ring;
}

DesignRequest at(const MoldState& state, IndexedMesh part) {
    DesignRequest request;
    request.part = std::make_shared<const IndexedMesh>(std::move(part));
    request.plane = state.plane;
    request.directionsChoice = DirectionsChoice::Normal;
    return request;
}

std::vector<FillableUndercut> needed(const IndexedMesh& part) {
    auto undercuts = fillableUndercuts(part, level, {});
    EXPECT_TRUE(undercuts.has_value());
    if (undercuts)
        std::erase_if(*undercuts, [](const FillableUndercut& u) { return !u.needed; });
    return undercuts ? *undercuts : std::vector<FillableUndercut>{};
}

} // namespace

TEST(Filling, UndercutsAreToldWithPlaceVolumeAndWalls) {
    const IndexedMesh part = test::together(standingRing(-10), standingRing(10));
    const auto undercuts = fillableUndercuts(part, level, {});
    ASSERT_TRUE(undercuts) << undercuts.error().english();
    ASSERT_GE(undercuts->size(), 2U);
    double last = std::numeric_limits<double>::infinity();
    for (const FillableUndercut& undercut : *undercuts) {
        EXPECT_LE(undercut.volume, last);
        last = undercut.volume;
        EXPECT_FALSE(undercut.joins);
        for (const int f : undercut.faces)
            EXPECT_TRUE(f >= 0 && f < part.faceCount());
        for (int v = 0; v < undercut.walls.vertexCount(); ++v)
            EXPECT_LT((undercut.walls.point(v) - undercut.place).norm(), 2 * undercut.size + 1);
    }
    EXPECT_EQ(needed(part).size(), 2U) << "two holes";
}

TEST(Filling, OneRingsHoleIsFilledAndTheOthersIsNamed) {
    const IndexedMesh part = test::together(standingRing(-10), standingRing(10));
    const std::vector<FillableUndercut> holes = needed(part);
    ASSERT_EQ(holes.size(), 2U);
    const std::vector<UndercutChoice> one{{holes[0].place, Treatment::Fill}};
    EXPECT_FALSE(planePasses(part, level, one, {}));
    const auto left = obstructionsAt(part, level, one, {}).obstructions;
    ASSERT_EQ(left.size(), 1U);
    EXPECT_LT(left[0].place.x() * holes[0].place.x(), 0) << "the other one";
    const std::vector<UndercutChoice> both{{holes[0].place, Treatment::Fill},
                                           {holes[1].place, Treatment::Fill}};
    EXPECT_TRUE(planePasses(part, level, both, {}));
}

TEST(Filling, WhatWasChosenIsFilledAndNothingElse) {
    const IndexedMesh part = test::together(standingRing(-10), test::sphere({10, 0, 1}, 3, 3));
    const std::vector<FillableUndercut> holes = needed(part);
    ASSERT_EQ(holes.size(), 1U);
    DesignRequest request = at(level, part);
    request.undercuts = {{holes[0].place, Treatment::Fill}};
    const Result<DesignResult> result = design(request);
    ASSERT_TRUE(result) << result.error().english();
    EXPECT_TRUE(result->castable) << result->certificate.reason;
    EXPECT_TRUE(result->obstructions.empty());
    EXPECT_NEAR(result->change.filledVolumeFraction, holes[0].volume / volume(part), 1e-6)
        << "the ball is undercut too, and bent";
}

TEST(Filling, WhatNoBendingFreesIsNotLeftToBending) {
    const IndexedMesh part = standingRing(0);
    const std::vector<FillableUndercut> holes = needed(part);
    ASSERT_EQ(holes.size(), 1U);
    DesignRequest request = at(level, part);
    request.fill = FillChoice::Auto;
    request.undercuts = {{holes[0].place, Treatment::Bend}};
    const Result<PartedPart> refused =
        filledSurface(part, level, {FillExtent::Needed, request.undercuts}, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Impossible);
    EXPECT_NE(refused.error().english().find("no bending frees it"), std::string::npos);
    const Result<DesignResult> result = design(request);
    ASSERT_TRUE(result) << result.error().english();
    EXPECT_FALSE(result->castable);
    EXPECT_EQ(result->obstructions.size(), 1U);
}

TEST(Filling, AnUndercutThatIsToBeBentIsNotFilledWithTheRest) {
    // Two balls above their equators: undercut on side 1, freed by bending or filling alike.
    const IndexedMesh part =
        test::together(test::sphere({-12, 0, 1.5}, 3, 3), test::sphere({12, 0, 1.5}, 3, 3));
    const auto all = filledSurface(part, level, {FillExtent::All, {}}, {});
    const auto undercuts = fillableUndercuts(part, level, {});
    ASSERT_TRUE(all && undercuts);
    ASSERT_EQ(undercuts->size(), 2U);
    const auto one =
        filledSurface(part, level, {FillExtent::All, {{(*undercuts)[0].place, Treatment::Bend}}}, {});
    ASSERT_TRUE(one) << one.error().english();
    EXPECT_NEAR(one->filledVolume, all->filledVolume - (*undercuts)[0].volume, 1e-4);
}

TEST(Filling, PiecesAreJoinedWhereThatWasChosen) {
    const IndexedMesh part = test::together(test::sphere({0, 0, 0}, 5, 3), test::sphere({0, 0, 11}, 4, 3));
    const std::vector<FillableUndercut> gaps = needed(part);
    ASSERT_EQ(gaps.size(), 1U);
    EXPECT_TRUE(gaps[0].joins);
    DesignRequest request = at(level, part);
    request.fill = FillChoice::Auto;
    const Result<DesignResult> unasked = design(request);
    EXPECT_FALSE(unasked && unasked->castable) << "nobody asked for one piece";
    request.undercuts = {{gaps[0].place, Treatment::Fill}};
    const Result<DesignResult> result = design(request);
    ASSERT_TRUE(result) << result.error().english();
    EXPECT_TRUE(result->castable) << result->certificate.reason;
    EXPECT_EQ(connectedComponents(*result->cast).count, 1);
}

TEST(Filling, ChoicesWithoutAPlaneAreRefused) {
    DesignRequest request = at(level, standingRing(0));
    request.plane.reset();
    request.undercuts = {{{0, 0, 0}, Treatment::Fill}};
    const Result<DesignResult> result = design(request);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Usage);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/edits.h"

#include "project/some_project.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector3d;

TEST(Edits, PlacingScalesThenMoves) {
    Placement placement;
    placement.scale = 10;
    placement.motion.translate(Vector3d(1, 2, 3));
    const IndexedMesh part = placed(box({0, 0, 0}, {1, 1, 1}), placement);
    EXPECT_EQ(part.point(7), Vector3d(11, 12, 13));
}

TEST(Edits, ThatChangeNothingKeepTheCast) {
    const Project project = someProject();
    EXPECT_TRUE(equal(withPlacement(project, project.placement), project));
    EXPECT_TRUE(equal(withState(project, *project.state, true), project));
    EXPECT_TRUE(equal(withDesignSettings(project, project.design), project));
    EXPECT_TRUE(equal(withPins(project, project.pins), project));
}

TEST(Edits, APinsNameIsNoPartOfWhatTheCastFollowsFrom) {
    const Project project = someProject();
    std::vector<NamedPin> pins = project.pins;
    pins[1].name = "tail";
    const Project after = withPins(project, pins);
    EXPECT_EQ(after.cast, project.cast);
    EXPECT_EQ(after.pins[1].name, "tail");
    EXPECT_FALSE(equal(after, project)) << "it is an edit all the same";
}

TEST(Edits, PinsKeepTheNamesOfThoseAtTheirPoints) {
    const std::vector<NamedPin> known = {{{Vector3d(1, 2, 3)}, "tail"}, {{Vector3d(4, 5, 6)}, {}}};
    const std::vector<NamedPin> pins = named({{Vector3d(7, 8, 9)}, {Vector3d(1, 2, 3)}}, known);
    ASSERT_EQ(pins.size(), 2U);
    EXPECT_EQ(pins[0].name, "");
    EXPECT_EQ(pins[1].name, "tail");
}

TEST(Edits, ThatTheCastDoesNotSurviveDropIt) {
    const Project project = someProject();
    Placement placement = project.placement;
    placement.scale *= 2;
    EXPECT_EQ(withPlacement(project, placement).cast, nullptr);
    EXPECT_EQ(withPlane(project, {Vector3d::UnitX(), 1}, true).cast, nullptr);
    EXPECT_EQ(withPins(project, {}).cast, nullptr);
    EXPECT_EQ(withUndercut(project, {1, 1, 1}, UndercutChoice::Treatment::Fill).cast, nullptr);
    EXPECT_EQ(withDesignSettings(project, {}).cast, nullptr);
    EXPECT_NE(withMoldSettings(project, {}).cast, nullptr);
}

TEST(Edits, PlaneDirectionsAndPinsMoveWithThePart) {
    const Project project = someProject();
    Placement placement = project.placement;
    placement.motion.prerotate(Eigen::AngleAxisd(0.3, Vector3d::UnitX()));
    placement.motion.pretranslate(Vector3d(4, 5, 6));
    placement.scale *= 3;
    const Project result = withPlacement(project, placement);
    for (int v = 0; v < project.part->vertexCount(); ++v)
        EXPECT_NEAR(result.state->plane.distance(result.part->point(v)),
                    3 * project.state->plane.distance(project.part->point(v)), 1e-9);
    EXPECT_NEAR(result.state->directions.d1.dot(result.state->plane.normal),
                project.state->directions.d1.dot(project.state->plane.normal), 1e-12);
    EXPECT_NEAR((result.undercuts[0].place - result.part->point(0)).norm(),
                3 * (project.undercuts[0].place - project.part->point(0)).norm(), 1e-9);
    EXPECT_NEAR(result.design.limits.axis->dot(result.state->plane.normal),
                project.design.limits.axis->dot(project.state->plane.normal), 1e-12);
    EXPECT_NEAR((result.pins[0].point - result.part->point(0)).norm(),
                3 * (project.pins[0].point - project.part->point(0)).norm(), 1e-9);
}

TEST(Edits, AnUndercutHasOneTreatmentOrNone) {
    const Project project = someProject();
    const UndercutChoice& known = project.undercuts.front();
    EXPECT_TRUE(equal(withUndercut(project, known.place, std::nullopt), [&] {
        Project other = project;
        other.undercuts.erase(other.undercuts.begin());
        other.cast = nullptr;
        return other;
    }()));
    const Project bent = withUndercut(project, known.place, UndercutChoice::Treatment::Bend);
    EXPECT_EQ(bent.undercuts.size(), project.undercuts.size());
    EXPECT_EQ(
        std::ranges::count(bent.undercuts, UndercutChoice{known.place, UndercutChoice::Treatment::Bend}), 1);
    EXPECT_TRUE(equal(withUndercut(project, {9, 9, 9}, std::nullopt), project));
}

TEST(Edits, AnotherPlaneKeepsDirectionsOnlyWhileTheyLeaveIt) {
    const Project project = someProject();
    PartingPlane near = project.state->plane;
    near.offset += 1;
    EXPECT_EQ(withPlane(project, near, true).state->directions, project.state->directions);
    const PartingPlane turned{-project.state->plane.normal, 0};
    EXPECT_EQ(withPlane(project, turned, true).state->directions, Directions::normalTo(turned));
}

TEST(Edits, DirectionsChosenByHandAreTakenAsTheyAre) {
    const Project project = someProject();
    const Vector3d n = project.state->plane.normal;
    const Directions turned{(n + Vector3d(0.1, 0.2, 0)).normalized(), -n};
    const Project result = withDirections(project, turned);
    EXPECT_EQ(result.state->directions, turned);
    EXPECT_EQ(result.state->plane, project.state->plane);
    EXPECT_EQ(result.design.directionsChoice, DirectionsChoice::Given);
    EXPECT_EQ(result.cast, nullptr);
}

TEST(Edits, ANewPartKeepsOnlySettings) {
    const Project project = someProject();
    const auto cube = std::make_shared<const IndexedMesh>(box({0, 0, 0}, {1, 1, 1}));
    const Project result = withPart(project, "cube", "cube.stl", cube, {});
    EXPECT_EQ(result.design, project.design);
    EXPECT_EQ(result.mold, project.mold);
    EXPECT_FALSE(result.state.has_value());
    EXPECT_TRUE(result.pins.empty());
    EXPECT_EQ(result.cast, nullptr);
}

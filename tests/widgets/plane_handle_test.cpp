// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/parting_line.h"
#include "scene/plane_handle.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace moldwright;
using namespace moldwright::scene;
using Eigen::Vector3d;

namespace {

constexpr ViewSize view{800, 600};

PlaneDrag dragOf(Grip grip, const Camera& camera, const MoldState& state) {
    const IndexedMesh box = test::box(Vector3d(-10, -10, -10), Vector3d(10, 10, 10));
    PlaneDrag drag{state, planeRectangle(state.plane, box.V), grip};
    const Vector3d pixel = camera.project(gripPlace(drag.rectangle, grip), view);
    drag.x = pixel.x();
    drag.y = pixel.y();
    return drag;
}

} // namespace

TEST(PlaneHandle, TheSlideGripFollowsThePointer) {
    const Camera camera = lookingFrom({}, Vector3d(1, -2, 0.5));
    const PlaneDrag drag = dragOf(Grip::SlidePlane, camera, {});
    const Vector3d target = gripPlace(drag.rectangle, Grip::SlidePlane) + Vector3d(0, 0, 4);
    const Vector3d pixel = camera.project(target, view);
    EXPECT_NEAR(drag.moved(camera, view, pixel.x(), pixel.y(), false).plane.offset, 4, 1e-9);
    EXPECT_NEAR(drag.moved(camera, view, pixel.x(), pixel.y() + 1, true).plane.offset, 4, 1e-12);
}

TEST(PlaneHandle, ATiltedPlaneKeepsItsMiddleAndTheDirectionsTheirAngles) {
    const Camera camera = lookingFrom({}, Vector3d(1, -2, 0.5));
    MoldState state;
    state.directions.d1 = Vector3d(0.3, 0, 1).normalized();
    const PlaneDrag drag = dragOf(Grip::TiltAboutV, camera, state);
    const MoldState tilted = drag.moved(camera, view, drag.x, drag.y - 60, false);
    EXPECT_LT(tilted.plane.normal.z(), 0.999);
    EXPECT_NEAR(tilted.plane.distance(drag.rectangle.centre), 0, 1e-9);
    EXPECT_NEAR(tilted.directions.d1.dot(tilted.plane.normal), state.directions.d1.z(), 1e-12);
    EXPECT_NEAR(tilted.directions.d2.dot(tilted.plane.normal), -1, 1e-12);
    // The grip went up along the normal: the plane there is higher.
    const Vector3d grip = gripPlace(drag.rectangle, Grip::TiltAboutV);
    EXPECT_LT(tilted.plane.distance(grip), -0.1);
}

TEST(PartingLine, AClosedCurveRoundASphere) {
    const IndexedMesh sphere = test::sphere(Vector3d::Zero(), 10, 4);
    double length = 0;
    for (const auto& [from, to] : partingSegments(sphere, {Vector3d(1, 2, 3).normalized(), 0}))
        length += (to - from).norm();
    EXPECT_NEAR(length, 2 * std::numbers::pi * 10, 0.3);
}

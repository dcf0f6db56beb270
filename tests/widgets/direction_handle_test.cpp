// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/direction_handle.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::scene;
using Eigen::Vector3d;

namespace {

constexpr ViewSize view{800, 600};

MoldState oblique() {
    MoldState state;
    state.plane = {Vector3d(1, 2, 3).normalized(), 4};
    state.directions = Directions::normalTo(state.plane);
    return state;
}

DirectionDrag dragOf(const MoldState& state, int side, const Camera& camera) {
    DirectionDrag drag{state, side, Vector3d(1, 0, 2), {}, {30}, 0, 0};
    drag.tip = drag.middle + 20 * state.directions.of(side);
    const Vector3d pixel = camera.project(drag.tip, view);
    drag.x = pixel.x();
    drag.y = pixel.y();
    return drag;
}

double tiltAfter(const DirectionDrag& drag, const Camera& camera, double right, bool coarse) {
    return leanOf(drag.moved(camera, view, drag.x + right, drag.y, coarse), drag.side).tiltDegrees;
}

} // namespace

TEST(Lean, ThereAndBackIsTheSameDirectionOnBothSides) {
    const MoldState state = oblique();
    for (const int side : {1, 2})
        for (const double tilt : {0.0, 0.5, 12.0, 29.9})
            for (const double way : {0.0, 75.0, 190.0, 359.0}) {
                const Vector3d d = leaning(state.plane, side, {tilt, way});
                EXPECT_NEAR(d.norm(), 1, 1e-15);
                const Lean lean = leanOf(withDirection(state, side, d), side);
                EXPECT_NEAR(lean.tiltDegrees, tilt, 1e-10);
                // Along the normal there is no way.
                EXPECT_NEAR(lean.wayDegrees, tilt > 0 ? way : 0, 1e-9);
            }
}

TEST(DirectionDrag, TheTipFollowsThePointer) {
    const Camera camera = lookingFrom({}, Vector3d(2, -1, 0.3));
    const DirectionDrag drag = dragOf(oblique(), 1, camera);
    const Vector3d to = drag.tip + 4 * camera.right() + 1 * camera.up();
    const Vector3d pixel = camera.project(to, view);
    const MoldState moved = drag.moved(camera, view, pixel.x(), pixel.y(), false);
    EXPECT_TRUE(moved.directions.d1.isApprox((to - drag.middle).normalized(), 1e-9));
    EXPECT_EQ(moved.directions.d2, drag.start.directions.d2);
    EXPECT_EQ(moved.plane, drag.start.plane);
}

TEST(DirectionDrag, ItSnapsToTheNormalAndStopsAtTheLimit) {
    const Camera camera = lookingFrom({}, Vector3d(2, -1, 0.3));
    for (const int side : {1, 2}) {
        const DirectionDrag drag = dragOf(oblique(), side, camera);
        EXPECT_EQ(tiltAfter(drag, camera, 1, false), 0);
        EXPECT_GT(tiltAfter(drag, camera, 60, false), 2);
        EXPECT_NEAR(tiltAfter(drag, camera, 700, false), 30, 1e-9);
        const double coarse = tiltAfter(drag, camera, 60, true);
        EXPECT_NEAR(coarse, 5 * std::round(coarse / 5), 1e-9);
        EXPECT_GT(coarse, 0);
    }
}

TEST(DirectionDrag, ItStaysWithinTheConeOfThePressAxis) {
    const Camera camera = lookingFrom({}, Vector3d(2, -1, 0.3));
    for (const int side : {1, 2}) {
        DirectionDrag drag = dragOf(oblique(), side, camera);
        const Vector3d axis = leaning(drag.start.plane, 2, {10, 40});
        drag.limits = {30, axis, 4};
        for (const double right : {-500.0, -50.0, 200.0, 700.0}) {
            const MoldState moved = drag.moved(camera, view, drag.x + right, drag.y - 80, false);
            const double cosine = std::abs(moved.directions.of(side).dot(axis));
            EXPECT_LE(degrees(std::acos(std::min(1.0, cosine))), 4.001);
        }
    }
}

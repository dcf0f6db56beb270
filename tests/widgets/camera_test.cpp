// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/camera.h"
#include "scene/orientation_cube.h"

#include <gtest/gtest.h>

using namespace moldwright::scene;
using Eigen::Vector3d;

namespace {

constexpr ViewSize view{800, 600};

Camera slanted(bool perspective) {
    Camera camera = lookingFrom({}, Vector3d(1, -2, 0.7));
    camera.focus = Vector3d(3, 4, 5);
    camera.perspective = perspective;
    return camera;
}

} // namespace

TEST(Camera, TheRayUnderAPixelPassesThroughWhatIsSeenThere) {
    for (const bool perspective : {false, true}) {
        const Camera camera = slanted(perspective);
        const Vector3d point(10, 2, 7);
        const Vector3d pixel = camera.project(point, view);
        const Ray ray = camera.rayAt(pixel.x(), pixel.y(), view);
        EXPECT_NEAR((point - ray.origin).cross(ray.direction).norm(), 0, 1e-8);
    }
}

TEST(Camera, OrbitKeepsThePivotOnTheScreen) {
    for (const bool perspective : {false, true}) {
        const Camera camera = slanted(perspective);
        const Vector3d pivot(6, 1, 8);
        const Camera turned = orbited(camera, pivot, 0.4, -0.3);
        EXPECT_NEAR((camera.project(pivot, view) - turned.project(pivot, view)).norm(), 0, 1e-8);
    }
}

TEST(Camera, ZoomKeepsWhatIsUnderThePointer) {
    const Camera camera = slanted(false);
    const Ray before = camera.rayAt(200, 450, view);
    const Ray after = zoomedAt(camera, 1.7, 200, 450, view).rayAt(200, 450, view);
    EXPECT_NEAR((before.origin - after.origin).cross(before.direction).norm(), 0, 1e-8);
}

TEST(Camera, FittedShowsEveryCorner) {
    const Eigen::AlignedBox3d box(Vector3d(-5, 0, 2), Vector3d(50, 20, 9));
    for (const bool perspective : {false, true}) {
        const Camera fit = fitted(slanted(perspective), box, view);
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3d pixel =
                fit.project(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)), view);
            EXPECT_GE(pixel.x(), 0);
            EXPECT_LE(pixel.x(), view.width);
            EXPECT_GE(pixel.y(), 0);
            EXPECT_LE(pixel.y(), view.height);
        }
    }
}

TEST(OrientationCube, AClickInTheMiddleOfAFaceAsksForThatView) {
    const Camera front = lookingFrom({}, Vector3d(0, -1, 0));
    EXPECT_EQ(cubeView(front, 0, 0), Vector3d(0, -1, 0));
    EXPECT_EQ(cubeView(front, 0.9, 0), Vector3d(1, -1, 0));
    EXPECT_EQ(cubeView(front, 0.9, 0.9), Vector3d(1, -1, 1));
    EXPECT_FALSE(cubeView(front, 1.3, 0));
}

TEST(OrientationCube, KnowsWhichFaceIsLookedAt) {
    for (int face = 0; face < 6; ++face)
        EXPECT_EQ(faceSeen(lookingFrom({}, cubeFaces()[static_cast<std::size_t>(face)])), face);
    EXPECT_EQ(faceSeen(slanted(false)), -1);
}

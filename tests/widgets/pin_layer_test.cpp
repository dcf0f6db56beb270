// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/pin_layer.h"

#include <gtest/gtest.h>

#include <vtkNew.h>
#include <vtkRenderer.h>

using namespace moldwright::scene;
using Eigen::Vector3d;

namespace {

constexpr ViewSize view{400, 300};

} // namespace

TEST(PinLayer, TheNearestPinIsFoundAndPinsComeBeforeSuggestedOnes) {
    const vtkNew<vtkRenderer> renderer;
    PinLayer layer;
    layer.addTo(renderer);
    layer.setLook(lightColours(), 1);
    ShownPins pins;
    pins.pins = {{0, Vector3d(0, 0, 0), Vector3d(0, 0, -5), false}, {1, Vector3d(10, 0, 0), {}, true}};
    pins.suggested = {Vector3d(0, 0, 0.2), Vector3d(0, 0, 10)};
    layer.set(pins);
    const Camera camera = lookingFrom({}, -Vector3d::UnitY());
    layer.arrange(camera, view);
    const auto at = [&](const Vector3d& place) {
        const Vector3d pixel = camera.project(place, view);
        return layer.at(camera, view, pixel.x(), pixel.y(), 12);
    };
    ASSERT_TRUE(at(Vector3d(0, 0, 0)));
    EXPECT_FALSE(at(Vector3d(0, 0, 0))->suggested);
    EXPECT_EQ(at(Vector3d(0, 0, 0))->number, 0);
    EXPECT_FALSE(at(Vector3d(0, 0, 0.2))->suggested) << "a pin covers what is suggested beside it";
    EXPECT_EQ(at(Vector3d(10, 0, 0))->number, 1);
    EXPECT_TRUE(at(Vector3d(0, 0, 10))->suggested);
    EXPECT_EQ(at(Vector3d(0, 0, 10))->number, 1);
    EXPECT_FALSE(at(Vector3d(30, 0, 0)));
    // Fewer pins leave nothing behind.
    layer.set({});
    EXPECT_FALSE(at(Vector3d(0, 0, 0)));
}

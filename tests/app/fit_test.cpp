// SPDX-License-Identifier: AGPL-3.0-or-later
// What brings things into sight: all, what is chosen, two fingers on a touchpad.
#include "app/window_driver.h"

#include "mesh/measures.h"
#include "view/part_view.h"
#include "window/main_window.h"
#include "window/workbench.h"

#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QTest>

#include <gtest/gtest.h>

using namespace moldwright;
using test::WindowDriver;

namespace {

double distanceAtRest(WindowDriver& driver) {
    QTest::qWait(300); // the camera eases
    return driver.window().view().camera().distance;
}

void pinch(PartView& view, const QPoint& at, double value) {
    QNativeGestureEvent event(Qt::ZoomNativeGesture, QPointingDevice::primaryPointingDevice(), 2, at, at,
                              view.mapToGlobal(at), value, {});
    QApplication::sendEvent(&view, &event);
}

} // namespace

TEST(Fit, BringsTheChosenPinIntoSightAndAllWhereNothingHasAPlace) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    const IndexedMesh& part = *driver.bench().project().part;
    int top = 0;
    part.V.col(2).maxCoeff(&top);
    const Eigen::Vector3d place = part.V.row(top).transpose();
    driver.bench().addPin(place);
    driver.press("Shift+F");
    const double all = distanceAtRest(driver);
    driver.selectRow("pin-0");
    driver.press("F");
    EXPECT_LT(distanceAtRest(driver), 0.6 * all);
    PartView& view = driver.window().view();
    EXPECT_LT((view.pixelOf(place) - view.rect().center()).manhattanLength(), 40);
    driver.shot("fit-selection");
    driver.selectRow("deform");
    driver.press("F");
    EXPECT_NEAR(distanceAtRest(driver), all, 0.05 * all);
}

TEST(Fit, TwoFingersZoomAboutThePlaceBetweenThem) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    PartView& view = driver.window().view();
    const scene::Camera before = view.camera();
    const QPoint at(view.width() / 2 + 80, view.height() / 2 - 50);
    const scene::ViewSize size{view.width() * view.devicePixelRatioF(),
                               view.height() * view.devicePixelRatioF()};
    const scene::Ray under =
        before.rayAt(at.x() * view.devicePixelRatioF(), at.y() * view.devicePixelRatioF(), size);
    const Eigen::Vector3d place =
        under.origin + under.direction * (before.focus - under.origin).dot(under.direction);
    pinch(view, at, 0.25);
    EXPECT_NEAR(view.camera().distance, before.distance / 1.25, 1e-9 * before.distance);
    EXPECT_LT((view.pixelOf(place) - at).manhattanLength(), 4);
    pinch(view, at, -0.2);
    EXPECT_NEAR(view.camera().distance, before.distance, 1e-9 * before.distance);
    pinch(view, at, -3); // what a touchpad should not say
    EXPECT_LT(view.camera().distance, 6 * before.distance);
}

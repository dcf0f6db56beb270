// SPDX-License-Identifier: AGPL-3.0-or-later
// F with the brush in hand: the pointer sizes it.
#include "app/window_driver.h"

#include "view/part_view.h"
#include "window/main_window.h"
#include "window/workbench.h"

#include <QMouseEvent>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>

using namespace moldwright;
using test::WindowDriver;

namespace {

void movePointer(PartView& view, const QPoint& to) {
    QMouseEvent move(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(&view, &move);
    QTest::qWait(60); // the view hears of the radius
}

} // namespace

TEST(Brush, IsSizedByThePointerAfterFAndEscGivesItBack) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    driver.press("B");
    PartView& view = driver.window().view();
    const QPoint middle = view.rect().center();
    movePointer(view, middle);
    const double first = driver.bench().brushRadius();
    const scene::Camera camera = view.camera();

    driver.press("F");
    movePointer(view, middle);
    movePointer(view, middle + QPoint(40, 0));
    const double larger = first * std::pow(1.01, 40);
    EXPECT_NEAR(driver.bench().brushRadius(), larger, 1e-9);
    QTest::mouseClick(&view, Qt::LeftButton, {}, middle + QPoint(40, 0));
    EXPECT_TRUE(driver.bench().project().importance.empty())
        << "the click ends the sizing, and paints nothing";
    movePointer(view, middle);
    EXPECT_NEAR(driver.bench().brushRadius(), larger, 1e-9);

    driver.press("F");
    movePointer(view, middle);
    movePointer(view, middle - QPoint(60, 0));
    EXPECT_LT(driver.bench().brushRadius(), 0.7 * larger);
    driver.press("Esc");
    QTest::qWait(60);
    EXPECT_NEAR(driver.bench().brushRadius(), larger, 1e-9);
    EXPECT_EQ(view.picking(), PartView::Picking::Stroke) << "the brush is still in hand";
    EXPECT_EQ(view.camera().distance, camera.distance);
}

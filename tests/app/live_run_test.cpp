// SPDX-License-Identifier: AGPL-3.0-or-later
// What is changed in the real window while the part bends.
#include "app/window_driver.h"

#include "mesh/measures.h"
#include "panels/property_panel.h"
#include "scene/scene.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/main_window.h"

#include <QApplication>
#include <QMouseEvent>
#include <QTest>

#include <gtest/gtest.h>

using namespace moldwright;
using test::WindowDriver;

namespace {

/// A sample at its best plane, bent a little and held.
void bendAndHold(WindowDriver& driver, const char* sample) {
    ASSERT_TRUE(driver.openSample(sample));
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().progress().size() >= 4; }, 180000));
    driver.press("Space");
    ASSERT_TRUE(driver.bench().resting());
    // A step under way ends, however busy the machine is.
    for (std::size_t seen = 0; seen != driver.bench().progress().size();) {
        seen = driver.bench().progress().size();
        QTest::qWait(1500);
    }
}

/// The face that looks most along the normal, of those near the top of the shape, where nothing hides it.
int faceTowards(const IndexedMesh& shape, const Eigen::Vector3d& normal) {
    const Eigen::VectorXd heights = shape.V * normal;
    const double nearTop = heights.maxCoeff() - 0.1 * (heights.maxCoeff() - heights.minCoeff());
    int best = 0;
    double most = -1;
    for (int f = 0; f < shape.faceCount(); ++f) {
        const double facing = doubleAreaVector(shape, f).normalized().dot(normal);
        if (facing > most && heights[shape.F(f, 0)] > nearTop) {
            most = facing;
            best = f;
        }
    }
    return best;
}

Eigen::Vector3d middleOf(const Points& V, const Eigen::RowVector3i& face) {
    return (V.row(face[0]) + V.row(face[1]) + V.row(face[2])) / 3;
}

void drag(PartView& view, QPoint from, QPoint to) {
    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 8; ++step) {
        const QPoint at = from + (to - from) * step / 8;
        QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(&view, &move);
        QTest::qWait(10);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
    QTest::qWait(50);
}

} // namespace

TEST(LiveRun, TheDraftTypedWhileItBendsIsReachedAndUndoneWithOneKey) {
    WindowDriver driver;
    ASSERT_NO_FATAL_FAILURE(bendAndHold(driver, "bent_beam"));
    const std::size_t steps = driver.bench().document().history().steps().size();
    driver.selectRow("deform");
    driver.type("field-draft", "3");
    EXPECT_EQ(driver.bench().document().history().steps().size(), steps + 1);
    driver.window().view().setFocus();
    driver.press("Ctrl+Z");
    EXPECT_EQ(driver.bench().project().design.draftDegrees, 1) << "undo works while it runs";
    driver.press("Ctrl+Shift+Z");
    driver.press("Space");
    ASSERT_TRUE(driver.waitIdle(180000));
    ASSERT_TRUE(driver.bench().project().cast);
    EXPECT_EQ(driver.bench().project().cast->draftDegrees, 3);
    EXPECT_EQ(driver.bench().project().design.draftDegrees, 3);
    EXPECT_TRUE(driver.bench().castIsProved());
    EXPECT_EQ(driver.bench().document().history().steps().size(), steps + 2);
}

TEST(LiveRun, ThePlaneDraggedWhileItBendsIsTheCasts) {
    WindowDriver driver;
    ASSERT_NO_FATAL_FAILURE(bendAndHold(driver, "bent_beam"));
    PartView& view = driver.window().view();
    const MoldState before = *driver.bench().shownState();
    const QPoint grip = view.gripPixel(scene::Grip::SlidePlane);
    const double way = 0.02 * diagonal(*driver.bench().project().part);
    const Eigen::Vector3d middle = before.plane.offset * before.plane.normal;
    drag(view, grip, grip + view.pixelOf(middle + way * before.plane.normal) - view.pixelOf(middle));
    const PartingPlane dragged = driver.bench().document().committed().state->plane;
    EXPECT_NE(dragged, before.plane);
    EXPECT_EQ(driver.bench().shownState()->plane, dragged) << "it stays where it was dragged to";
    driver.shot("60-plane-dragged-in-a-run");
    const std::size_t frames = driver.bench().progress().size();
    driver.press("Space");
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().progress().size() > frames; }));
    ASSERT_TRUE(driver.waitIdle(180000));
    ASSERT_TRUE(driver.bench().project().cast);
    EXPECT_EQ(driver.bench().project().cast->state.plane, dragged);
    EXPECT_TRUE(driver.bench().castIsProved());
}

TEST(LiveRun, APinClickedOnTheBentShapeIsAPointOfThePartAndEndsInThePlane) {
    WindowDriver driver;
    ASSERT_NO_FATAL_FAILURE(bendAndHold(driver, "bent_beam"));
    const DesignFrame frame = driver.bench().frame()->frame;
    const MoldState state = *driver.bench().shownState();
    const int face = faceTowards(*frame.shape, state.plane.normal);
    const Eigen::Vector3d there = middleOf(frame.shape->V, frame.shape->F.row(face));
    const Eigen::Vector3d inPart = middleOf(*frame.before, frame.shape->F.row(face));
    PartView& view = driver.window().view();
    view.lookFrom(state.plane.normal);
    driver.press("P");
    // The view turns there; from where it stood the place may be hidden.
    ASSERT_TRUE(driver.waitFor([&] { return view.camera().backwards().isApprox(state.plane.normal, 1e-6); }));
    QTest::mouseClick(&view, Qt::LeftButton, {}, view.pixelOf(there));
    QTest::qWait(100);
    const double size = diagonal(*driver.bench().project().part);
    ASSERT_EQ(driver.bench().project().pins.size(), 1U);
    EXPECT_LT((driver.bench().project().pins[0].point - inPart).norm(), 0.05 * size);
    ASSERT_EQ(driver.window().view().scene().pins().pins().pins.size(), 1U);
    EXPECT_LT((driver.window().view().scene().pins().pins().pins[0].place - there).norm(), 0.05 * size);
    driver.shot("61-pin-set-in-a-run");
    driver.press("Ctrl+Z");
    EXPECT_TRUE(driver.bench().project().pins.empty());
    driver.press("Esc");
    driver.press("Space");
    ASSERT_TRUE(driver.waitIdle(180000));
    EXPECT_TRUE(driver.bench().castIsProved());
}

TEST(LiveRun, WhatARunCannotTakeUpWaitsForTheNextAndIsTold) {
    WindowDriver driver;
    ASSERT_NO_FATAL_FAILURE(bendAndHold(driver, "bent_beam"));
    Project other = driver.bench().document().committed();
    other.design.seed = 7;
    driver.bench().document().edit(QStringLiteral("Another seed"), other);
    EXPECT_EQ(driver.bench().messages()->at(0).standing, Standing::Warning);
    driver.window().view().setFocus();
    driver.press("Space");
    ASSERT_TRUE(driver.waitIdle(180000));
    EXPECT_FALSE(driver.bench().project().cast) << "it is not of these settings";
    EXPECT_EQ(driver.bench().project().design.seed, 7U);
    driver.press("Ctrl+Z");
    EXPECT_TRUE(driver.bench().project().cast) << "the cast is one step back";
    EXPECT_EQ(driver.bench().project().design.seed, 1U);
}

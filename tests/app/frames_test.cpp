// SPDX-License-Identifier: AGPL-3.0-or-later
// The frames of a run: kept, gone back to, and gone on from.
#include "app/window_driver.h"

#include "panels/progress_plots.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/frame_history.h"
#include "window/main_window.h"

#include <QSlider>
#include <QTest>

#include <gtest/gtest.h>

using namespace moldwright;
using test::WindowDriver;

namespace {

DesignFrame frameOf(int step) {
    DesignFrame frame;
    frame.step = step;
    frame.shape =
        std::make_shared<const IndexedMesh>(IndexedMesh{Points::Zero(1000, 3), Triangles::Zero(2000, 3)});
    return frame;
}

} // namespace

TEST(FrameHistory, IsThinnedEvenlyWhenFullAndKeepsFirstAndNewest) {
    FrameHistory history(20 * 48000);
    for (int step = 1; step <= 500; ++step) {
        history.add(frameOf(step));
        ASSERT_LE(history.bytes(), 20U * 48000);
        ASSERT_EQ(history.frames().front().step, 1);
        ASSERT_EQ(history.frames().back().step, step);
    }
    const auto& frames = history.frames();
    EXPECT_GE(frames.size(), 9U);
    const int stride = frames[1].step - frames[0].step;
    for (std::size_t i = 1; i + 1 < frames.size(); ++i)
        EXPECT_EQ(frames[i].step - frames[i - 1].step, stride);
}

TEST(Frames, AreGoneBackToSteppedAndGoneOnFrom) {
    WindowDriver driver;
    Workbench& bench = driver.bench();
    ASSERT_TRUE(driver.openSample("bent_beam"));
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitFor([&] { return bench.progress().size() >= 6; }, 180000));
    driver.press("Space");
    QTest::qWait(400); // a step under way ends
    const std::size_t steps = bench.progress().size();
    driver.press("N");
    ASSERT_TRUE(driver.waitFor([&] { return bench.progress().size() == steps + 1; }));
    QTest::qWait(300);
    EXPECT_EQ(bench.progress().size(), steps + 1) << "one step and no more";
    EXPECT_TRUE(bench.resting());

    // Back by the slider and by keys: the view shows that frame.
    auto* slider = driver.window().findChild<QSlider*>(QStringLiteral("frames"));
    ASSERT_TRUE(slider && slider->isVisible());
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Home);
    EXPECT_EQ(bench.frameInView(), 0);
    EXPECT_TRUE(driver.waitFor([&] { return bench.shownMesh() == bench.keptFrames()[0].shape; }));
    driver.window().view().setFocus();
    driver.press("Alt+.");
    driver.press("Alt+.");
    driver.press("Alt+,");
    EXPECT_EQ(bench.frameInView(), 1);
    ASSERT_TRUE(driver.waitFor([&] { return bench.shownMesh() == bench.keptFrames()[1].shape; }));
    driver.shot("62-frames");
    const DesignFrame from = bench.keptFrames()[1];

    // Another run begins there.
    const std::size_t edits = bench.document().history().steps().size();
    driver.press("Ctrl+Alt+Return");
    ASSERT_TRUE(driver.waitFor([&] { return bench.document().history().steps().size() == edits + 1; }));
    EXPECT_EQ(bench.project().state->plane, from.state.plane);
    ASSERT_TRUE(driver.waitIdle(180000));
    EXPECT_TRUE(bench.castIsProved());

    // And back once more when the run has ended.
    driver.window().view().setFocus();
    driver.press("Alt+,");
    EXPECT_TRUE(driver.waitFor([&] { return !bench.castShown(); }));
    driver.press("Ctrl+Z");
    EXPECT_FALSE(bench.frame()) << "an edit leaves the frames";
}

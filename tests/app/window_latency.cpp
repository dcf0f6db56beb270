// SPDX-License-Identifier: AGPL-3.0-or-later
// How long the window's event loop is blocked at a time, with a mesh of 300,000 faces: for each thing a user
// does the longest gap, and the time to draw one picture. No test, since times are the machine's.
#include "app/window_driver.h"

#include "exchange/mesh_file.h"
#include "panels/quantity_spin_box.h"
#include "support/folders.h"
#include "support/shapes.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/live_maps.h"
#include "window/main_window.h"
#include "window/workbench.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QSlider>
#include <QTest>
#include <QTimer>

#include <algorithm>
#include <cstdio>

using namespace moldwright;

namespace {

/// The longest time between two turns of the event loop, and the most that the interface thread itself worked
/// in between: on a busy machine it also waits for its turn.
class LongestGap : public QObject {
public:
    struct Longest {
        double gap = 0; ///< ms
        double work = 0;
    };

    LongestGap() {
        connect(&m_tick, &QTimer::timeout, this, [this] {
            const double gap = ms(CLOCK_MONOTONIC) - m_gapFrom;
            const double work = ms(CLOCK_THREAD_CPUTIME_ID) - m_workFrom;
            m_longest = {std::max(m_longest.gap, gap), std::max(m_longest.work, work)};
            restart();
        });
        restart();
        m_tick.start(1);
    }
    Longest take() {
        restart();
        return std::exchange(m_longest, {});
    }

private:
    static double ms(clockid_t clock) {
        timespec now{};
        clock_gettime(clock, &now);
        return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
    }
    void restart() {
        m_gapFrom = ms(CLOCK_MONOTONIC);
        m_workFrom = ms(CLOCK_THREAD_CPUTIME_ID);
    }

    QTimer m_tick;
    double m_gapFrom = 0;
    double m_workFrom = 0;
    Longest m_longest;
};

void tell(const char* what, const LongestGap::Longest& longest) {
    std::printf("%-28s longest gap %5.0f ms, own work %5.0f ms\n", what, longest.gap, longest.work);
    std::fflush(stdout);
}

/// A ring of 300,000 faces, twisted out of its plane, 80 mm across.
IndexedMesh ring() {
    IndexedMesh mesh = test::torus(30, 10, 600, 250);
    for (int v = 0; v < mesh.vertexCount(); ++v)
        mesh.V(v, 2) += 0.01 * mesh.V(v, 0) * mesh.V(v, 0);
    return mesh;
}

void drag(PartView& view, QPoint from, QPoint way, Qt::MouseButton button, Qt::KeyboardModifiers keys) {
    QTest::mousePress(&view, button, keys, from);
    for (int step = 1; step <= 20; ++step) {
        const QPoint at = from + way * step / 20;
        QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, button, keys);
        QApplication::sendEvent(&view, &move);
        QTest::qWait(16);
    }
    QTest::mouseRelease(&view, button, keys, from + way);
}

void measure(const char* what, LongestGap& gap, test::WindowDriver& driver,
             const std::function<void()>& act) {
    driver.waitIdle();
    QTest::qWait(500);
    (void)gap.take();
    act();
    driver.waitIdle();
    QTest::qWait(300);
    tell(what, gap.take());
}

/// What the views show and how they are looked at.
void measureViews(LongestGap& gap, test::WindowDriver& driver) {
    PartView& view = driver.window().view();
    const QPoint middle(view.width() / 2, view.height() / 2);
    measure("orbit", gap, driver, [&] { drag(view, middle, {80, 20}, Qt::MiddleButton, Qt::ShiftModifier); });
    measure("section", gap, driver, [&] { driver.press("C"); });
    measure("move the section", gap, driver, [&] {
        auto* slider = driver.window().findChild<QSlider*>(QStringLiteral("view-1-section-slider"));
        for (int step = 0; step < 10; ++step)
            QTest::keyClick(slider, Qt::Key_PageDown, {}, 20);
    });
    driver.press("C");
    measure("two views", gap, driver, [&] { driver.press("Alt+2"); });
    measure("four views", gap, driver, [&] { driver.press("Alt+4"); });
    measure("linked orbit of four", gap, driver, [&] {
        driver.press("Shift+L");
        PartView& free = driver.window().view();
        drag(free, {free.width() / 2, free.height() / 2}, {80, 20}, Qt::MiddleButton, Qt::ShiftModifier);
        driver.press("Shift+L");
    });
    measure("one view", gap, driver, [&] { driver.press("Alt+1"); });
    for (const char* theme : {"theme-dark", "theme-light"})
        measure(theme, gap, driver,
                [&] { driver.window().actions()[QString::fromLatin1(theme)]->trigger(); });
}

/// What changes the project.
void measureEdits(LongestGap& gap, test::WindowDriver& driver) {
    PartView& view = driver.window().view();
    measure("drag the plane", gap, driver,
            [&] { drag(view, view.gripPixel(scene::Grip::SlidePlane), {0, -40}, Qt::LeftButton, {}); });
    measure("drag a direction", gap, driver,
            [&] { drag(view, view.gripPixel(scene::Grip::Direction1), {40, 0}, Qt::LeftButton, {}); });
    measure("undo", gap, driver, [&] { driver.press("Ctrl+Z"); });
    for (const char* row : {"plane", "pins", "direction-1", "importance", "mold", "part"})
        measure((std::string("choose ") + row).c_str(), gap, driver, [&] { driver.selectRow(row); });
    driver.press("B");
    const QPoint onTop = view.pixelOf(driver.bench().project().part->V.colwise().mean().transpose());
    measure("paint a stroke", gap, driver, [&] { drag(view, onTop, {60, 10}, Qt::LeftButton, {}); });
    measure("undo the stroke", gap, driver, [&] { driver.press("Ctrl+Z"); });
    driver.press("Esc");
    measure("turn by 90°", gap, driver,
            [&] { driver.window().actions()[QStringLiteral("turn-x")]->trigger(); });
    measure("best plane", gap, driver, [&] { driver.press("Ctrl+B"); });
    measure("autosave's copy", gap, driver, [&] { QTest::qWait(6000); });
}

/// A map in the view, until it is painted.
void measureMap(LongestGap& gap, test::WindowDriver& driver, const char* what, const char* keys,
                DisplayMode mode) {
    measure(what, gap, driver, [&] {
        driver.press(keys);
        driver.waitFor(
            [&] { return !isMap(mode) || driver.bench().map(ViewContent::Newest, mode) != nullptr; });
    });
}

/// The run, what it leaves, and the mold.
void measureCast(LongestGap& gap, test::WindowDriver& driver, const std::filesystem::path& folder) {
    measure("run", gap, driver, [&] {
        driver.press("Ctrl+Return");
        driver.waitIdle(600000);
    });
    measureMap(gap, driver, "deviation", "Shift+D", DisplayMode::Deviation);
    measureMap(gap, driver, "strain", "Shift+S", DisplayMode::Strain);
    measureMap(gap, driver, "importance", "I", DisplayMode::Importance);
    measureMap(gap, driver, "undercuts", "U", DisplayMode::Undercuts);
    measure("undo the run", gap, driver, [&] { driver.press("Ctrl+Z"); });
    measure("redo the run", gap, driver, [&] { driver.press("Ctrl+Shift+Z"); });
    measure("build the mold", gap, driver, [&] {
        driver.press("Ctrl+M");
        driver.waitIdle(600000);
        QTest::qWait(1500);
    });
    measure("demolding slider", gap, driver, [&] {
        auto* slider = driver.window().findChild<QSlider*>(QStringLiteral("opening"));
        for (int step = 0; step < 12; ++step)
            QTest::keyClick(slider, Qt::Key_PageDown, {}, 20);
    });
    measure("save", gap, driver, [&] {
        driver.answerFileDialog(QString::fromStdString((folder / "saved.moldwright").string()));
        driver.press("Ctrl+Shift+S");
        QTest::qWait(1000);
    });
}

void measurePictures(test::WindowDriver& driver) {
    PartView& view = driver.window().view();
    for (const bool coarse : {true, false}) {
        view.setCoarse(coarse);
        QElapsedTimer clock;
        clock.start();
        for (int i = 0; i < 5; ++i) {
            view.redraw();
            driver.waitFor([&] {
                (void)view.picture();
                return !view.drawing();
            });
        }
        std::printf("%-28s %5lld ms\n", coarse ? "picture by stand-in" : "picture of the whole",
                    static_cast<long long>(clock.elapsed() / 5));
    }
}

/// How many pictures a second reach the screen while the shape turns, with some 14,000 points.
void measureFrames(test::WindowDriver& driver, const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / "small.ply";
    if (!writeMesh(file, test::torus(30, 10, 168, 84), MeshFormat::Ply))
        return;
    driver.openMesh(QString::fromStdString(file.string()), 80);
    driver.waitIdle();
    PartView& view = driver.window().view();
    int pictures = 0;
    QObject::connect(&view, &QOpenGLWidget::frameSwapped, [&] { ++pictures; });
    view.setLive(true);
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < 4000) {
        view.followCamera(scene::orbited(view.camera(), view.scene().middle(), 0.02, 0));
        const int before = pictures;
        driver.waitFor([&] { return pictures > before; });
    }
    std::printf("%-28s %5.1f a second\n", "pictures, 14,112 points",
                1000.0 * pictures / static_cast<double>(clock.elapsed()));
}

} // namespace

/// With a mesh file: that part, and how it is made castable too.
int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    const QApplication application(argc, argv);
    prepareApplication();
    test::WindowDriver driver;
    const test::ScratchFolder folder;
    std::filesystem::path file = folder.path() / "ring.ply";
    if (argc > 1)
        file = argv[1];
    else if (!writeMesh(file, ring(), MeshFormat::Ply))
        return 1;
    LongestGap gap;
    driver.openSample("praline");
    // The first picture of each view and kind compiles what draws it: no matter of size.
    for (const char* keys : {"Alt+4", "C", "C", "Alt+2", "Alt+1", "C", "C"}) {
        driver.press(keys);
        QTest::qWait(500);
    }
    measure("open", gap, driver, [&] { driver.openMesh(QString::fromStdString(file.string()), 80); });
    measureViews(gap, driver);
    measureEdits(gap, driver);
    measureMap(gap, driver, "draft map", "D", DisplayMode::DraftMap);
    measureMap(gap, driver, "undercut depth", "Shift+U", DisplayMode::UndercutDepth);
    if (argc > 1)
        measureCast(gap, driver, folder.path());
    measurePictures(driver);
    measureFrames(driver, folder.path());
    return 0;
}

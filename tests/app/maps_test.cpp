// SPDX-License-Identifier: AGPL-3.0-or-later
// Maps over the surface, sections and measuring, by the events a user makes.
#include "app/window_driver.h"

#include "mesh/measures.h"
#include "panels/quantity_spin_box.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/main_window.h"
#include "window/view_area.h"
#include "window/view_pane.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QMouseEvent>
#include <QSlider>
#include <QTest>

#include <gtest/gtest.h>

#include <numeric>

using namespace moldwright;
using test::WindowDriver;

namespace {

/// Waits for the map that the active view is to show.
const FaceMap* shownMap(WindowDriver& driver) {
    const ViewSettings& settings = driver.window().views().active().settings();
    const FaceMap* map = nullptr;
    (void)driver.waitFor([&] {
        map = driver.bench().map(settings.content, settings.mode);
        return map != nullptr;
    });
    QTest::qWait(100);
    return map;
}

/// How many pixels of the view have about this colour, whatever its light.
int pixelsLike(PartView& view, const std::function<bool(QColor)>& like) {
    const QImage picture = view.grabFramebuffer();
    int count = 0;
    for (int y = 0; y < picture.height(); y += 2)
        for (int x = 0; x < picture.width(); x += 2)
            count += like(picture.pixelColor(x, y));
    return count;
}

void hoverAt(PartView& view, QPoint at) {
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(&view, &move);
}

void clickAt(PartView& view, QPoint at) {
    hoverAt(view, at);
    QTest::mouseClick(&view, Qt::LeftButton, {}, at);
    QTest::qWait(50);
}

} // namespace

TEST(Maps, UndercutDepthFollowsThePlane) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("goat_head"));
    driver.press("Shift+U");
    const FaceMap* map = shownMap(driver);
    ASSERT_TRUE(map);
    EXPECT_GT(map->largest, 1);
    const DraftAnalysis& analysis = driver.bench().analysis()->analysis;
    ASSERT_EQ(map->values.size(), analysis.violating.size());
    double undercut = 0;
    for (std::size_t f = 0; f < map->values.size(); ++f) {
        EXPECT_TRUE(analysis.violating[f] || map->values[f] == 0) << f;
        if (map->values[f] > 0)
            undercut += doubleAreaVector(*map->request.surface, static_cast<int>(f)).norm() / 2;
    }
    EXPECT_NEAR(std::accumulate(map->areas.begin(), map->areas.end(), 0.0), undercut, 1e-6 * undercut);
    driver.shot("40-undercut-depth");
    const std::vector<double> before = map->values;
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    ASSERT_TRUE(driver.waitFor([&] {
        const FaceMap* now = driver.bench().map(ViewContent::Newest, DisplayMode::UndercutDepth);
        return now && now->request.state == driver.bench().project().state;
    }));
    EXPECT_NE(driver.bench().map(ViewContent::Newest, DisplayMode::UndercutDepth)->values, before);
    driver.press("U");
}

TEST(Maps, DeviationAndStrainWaitForACastAndThenTellWhatThePanelTells) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("bent_beam"));
    driver.press("Shift+D");
    EXPECT_FALSE(driver.bench().map(ViewContent::Newest, DisplayMode::Deviation));
    driver.shot("41-no-cast-yet");
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(300000));
    const auto cast = driver.bench().project().cast;
    ASSERT_TRUE(cast);
    const FaceMap* deviation = shownMap(driver);
    ASSERT_TRUE(deviation);
    const double size = diagonal(*driver.bench().project().part);
    EXPECT_GT(deviation->largest, 0);
    EXPECT_LE(deviation->largest, cast->change.maxDistance * size * 1.0001);
    driver.shot("42-deviation");

    driver.press("Shift+S");
    const FaceMap* strain = shownMap(driver);
    ASSERT_TRUE(strain);
    EXPECT_EQ(strain->values.size(), static_cast<std::size_t>(cast->mesh->faceCount()));
    EXPECT_GT(strain->largest, 0);
    driver.shot("43-strain");
    driver.press("U");
}

TEST(Maps, SteelIsShownOnTheHalvesWithItsLimit) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Shift+M");
    PartView& view = driver.window().view();
    const auto& legend = view.scene().overlay().legend();
    const auto shows = [&](const char* words) { return legend.words().find(words) != std::string::npos; };
    ASSERT_TRUE(driver.waitFor([&] { return shows("build the mold"); })) << legend.words();
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(300000));
    driver.bench().document().edit({}, [&] {
        Project thin = driver.bench().project();
        thin.mold.ceiling = 1.5; // over half 1; 2 mm are asked for
        thin.mold.step = 0;
        return thin;
    }());
    driver.press("Ctrl+M");
    ASSERT_TRUE(driver.waitIdle());
    ASSERT_TRUE(driver.waitFor([&] { return shows("below 2 mm, the least asked for"); })) << legend.words();
    EXPECT_TRUE(shows("thinnest 1.5 mm")) << legend.words();
    EXPECT_NE(view.scene().half(1), driver.bench().drawnHalf(1)) << "walls are cut into finer faces";
    driver.press("9"); // from below: into half 1, opened
    ASSERT_TRUE(driver.waitFor([&] { return !view.drawing(); }));
    QTest::qWait(1500);
    driver.shot("53-steel");
    const auto red = [](QColor c) {
        return c.red() > 120 && c.red() > 2 * c.green() && c.red() > 2 * c.blue();
    };
    EXPECT_GT(pixelsLike(view, red), 25) << "the thin ceiling";
    driver.press("U");
    ASSERT_TRUE(driver.waitFor([&] { return view.scene().half(1) == driver.bench().drawnHalf(1); }));
}

TEST(Section, OpensAtThePartingPlaneAndFollowsItsFields) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    PartView& view = driver.window().view();
    driver.press("C");
    ASSERT_TRUE(view.scene().cut());
    EXPECT_EQ(*view.scene().cut(), driver.bench().project().state->plane);
    driver.press("8");
    ASSERT_TRUE(driver.waitFor([&] { return !view.drawing(); }));
    QTest::qWait(400);
    driver.shot("50-section");
    // The flat colour of the section fills the middle of the view.
    const auto flat = [](QColor c) { return c == QColor(158, 162, 167); };
    EXPECT_GT(pixelsLike(view, flat), 500);

    driver.type("view-1-section-offset", "3");
    EXPECT_NEAR(view.scene().cut()->offset, driver.bench().project().state->plane.offset + 3, 1e-9);
    auto* flip = driver.window().findChild<QWidget*>(QStringLiteral("view-1-section-flip"));
    QTest::mouseClick(flip, Qt::LeftButton);
    QTest::qWait(30);
    EXPECT_TRUE(view.scene().cut()->normal.isApprox(-driver.bench().project().state->plane.normal));
    auto* slider = driver.window().findChild<QSlider*>(QStringLiteral("view-1-section-slider"));
    const double before = view.scene().cut()->offset;
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_PageUp);
    QTest::qWait(30);
    EXPECT_NE(view.scene().cut()->offset, before);
    auto* across = driver.window().findChild<QComboBox*>(QStringLiteral("view-1-section-across"));
    across->setFocus();
    QTest::keyClick(across, Qt::Key_Down);
    QTest::qWait(100);
    EXPECT_NEAR(std::abs(view.scene().cut()->normal.x()), 1, 1e-12);
    driver.press("0");
    QTest::qWait(400);
    driver.shot("51-section-x");
    view.setFocus();
    driver.press("C");
    EXPECT_FALSE(view.scene().cut());
}

TEST(Section, LiesInAnyPlaneThatTheViewFaces) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    PartView& view = driver.window().view();
    const scene::Camera oblique = scene::lookingFrom(view.camera(), Eigen::Vector3d(1, -2, 0.7));
    view.standAt(oblique);
    driver.press("C");
    auto* across = driver.window().findChild<QComboBox*>(QStringLiteral("view-1-section-across"));
    across->setFocus();
    QTest::keyClick(across, Qt::Key_End);
    QTest::qWait(100);
    ASSERT_TRUE(view.scene().cut());
    const PartingPlane cut = *view.scene().cut();
    EXPECT_TRUE(cut.normal.isApprox(oblique.backwards(), 1e-9));
    EXPECT_NEAR(cut.distance(view.scene().middle()), 0, 1e-9);
    ASSERT_TRUE(driver.waitFor([&] { return !view.drawing(); }));
    driver.shot("51-section-facing");
    const auto flat = [](QColor c) { return c == QColor(158, 162, 167); };
    EXPECT_GT(pixelsLike(view, flat), 500) << "the cut is filled";
    // It stays where it is in the part when the view turns, and moves along its own normal.
    driver.press("7");
    QTest::qWait(400);
    EXPECT_EQ(*view.scene().cut(), cut);
    auto* slider = driver.window().findChild<QSlider*>(QStringLiteral("view-1-section-slider"));
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_PageUp);
    QTest::qWait(30);
    EXPECT_EQ(view.scene().cut()->normal, cut.normal);
    EXPECT_GT(view.scene().cut()->offset, cut.offset);
}

TEST(Section, CutsTheMoldOpenToo) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(300000));
    driver.press("Ctrl+M");
    ASSERT_TRUE(driver.waitIdle());
    QTest::qWait(900);
    driver.press("C");
    auto* across = driver.window().findChild<QComboBox*>(QStringLiteral("view-1-section-across"));
    across->setFocus();
    QTest::keyClick(across, Qt::Key_Down);
    QTest::qWait(300);
    driver.shot("52-mold-section");
    PartView& view = driver.window().view();
    ASSERT_TRUE(view.scene().cut());
    EXPECT_GT(view.scene().cut()->normal.dot(view.camera().backwards()), 0) << "the section faces the eye";
    driver.window().view().setFocus();
    driver.press("C");
}

TEST(Measure, TellsPlaceDistanceAndAngleAndCopiesThem) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    PartView& view = driver.window().view();
    driver.press("M");
    EXPECT_EQ(view.picking(), PartView::Picking::Place);
    const Eigen::Vector3d middle = boundingBox(*driver.bench().project().part).center();
    const QPoint at = view.pixelOf(middle);
    hoverAt(view, at + QPoint(-10, 0));
    const auto* reading = driver.window().findChild<QLabel*>(QStringLiteral("reading"));
    ASSERT_TRUE(reading && reading->isVisible());
    EXPECT_TRUE(reading->text().contains(QStringLiteral("Draft"))) << reading->text().toStdString();
    EXPECT_TRUE(reading->text().contains(QStringLiteral("thickness")));
    driver.shot("60-reading");

    for (const QPoint& way : {QPoint(-40, 0), QPoint(0, 0), QPoint(0, 40)})
        clickAt(view, at + way);
    driver.shot("61-measured");
    driver.press("Ctrl+C");
    const QStringList lines = QGuiApplication::clipboard()->text().split(u'\n');
    ASSERT_EQ(lines.size(), 5) << lines.join(u'|').toStdString();
    EXPECT_TRUE(lines[3].startsWith(QStringLiteral("Distance: ")));
    EXPECT_TRUE(lines[4].startsWith(QStringLiteral("Angle: ")));

    driver.press("Esc");
    EXPECT_EQ(view.picking(), PartView::Picking::Nothing);
    EXPECT_FALSE(driver.window().actions()[QStringLiteral("copy-measured")]->isEnabled());
}

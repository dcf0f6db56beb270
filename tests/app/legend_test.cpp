// SPDX-License-Identifier: AGPL-3.0-or-later
// What is drawn flat over a view leaves the shape free: in every layout, at every size, in every language.
#include "app/window_driver.h"

#include "view/part_view.h"
#include "window/main_window.h"
#include "window/view_area.h"
#include "window/view_pane.h"

#include <QTest>

#include <gtest/gtest.h>

using namespace moldwright;
using namespace Qt::StringLiterals;
using scene::PanelForm;
using scene::Spot;
using test::WindowDriver;

namespace {

scene::ViewSize sizeOf(const PartView& view) {
    return {view.width() * view.devicePixelRatioF(), view.height() * view.devicePixelRatioF()};
}

void expectFree(PartView& view, const std::string& where) {
    const scene::ViewSize size = sizeOf(view);
    const std::optional<Spot> shape = view.scene().shapeSpot(view.camera(), size);
    ASSERT_TRUE(shape) << where;
    const Spot legend = view.scene().overlay().legend().spot();
    EXPECT_FALSE(legend.overlaps(*shape))
        << where << ": legend to " << legend.width << " × " << legend.height << ", shape from " << shape->left
        << ", " << shape->bottom << " in " << size.width << " × " << size.height;
    EXPECT_GT(legend.width, 0) << where;
    EXPECT_LE(legend.left + legend.width, size.width) << where;
    EXPECT_FALSE(view.scene().overlay().stateSpot(size).overlaps(*shape)) << where << ": state";
    EXPECT_GT(std::max(shape->width / size.width, shape->height / size.height), 0.35)
        << where << ": and the shape is large enough to be looked at";
}

void expectAllFree(WindowDriver& driver, const char* mode, const std::string& where) {
    for (ViewPane* pane : driver.window().views().shown()) {
        QTest::mouseClick(&pane->view(), Qt::LeftButton, {}, QPoint(6, pane->view().height() / 2));
        driver.press(mode);
    }
    ASSERT_TRUE(driver.waitIdle());
    driver.press("Shift+F");
    QTest::qWait(900); // the cameras come to rest
    for (ViewPane* pane : driver.window().views().shown()) {
        ASSERT_TRUE(driver.waitFor([&] { return !pane->view().drawing(); }));
        expectFree(pane->view(), where + ' ' + mode + ' ' + pane->standpoint().toStdString());
    }
}

} // namespace

class Legends : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Languages, Legends, testing::Values("de", "zh_CN"));

TEST_P(Legends, AndStatesLeaveTheShapeFree) {
    WindowDriver driver;
    driver.program().setLanguage(QString::fromLatin1(GetParam()));
    QTest::qWait(100);
    ASSERT_TRUE(driver.openSample("fish"));
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    for (const QSize size : {QSize(1280, 800), QSize(1440, 900), QSize(1920, 1080)}) {
        const bool dark = size.width() == 1440;
        driver.window().actions()[dark ? u"theme-dark"_s : u"theme-light"_s]->trigger();
        driver.window().resize(size);
        for (const char* layout : {"Alt+1", "Alt+2", "Alt+4"}) {
            driver.press(layout);
            for (const char* mode : {"D", "Shift+U", "U"}) {
                const std::string where =
                    std::string(GetParam()) + '-' + std::to_string(size.width()) + '-' + layout;
                ASSERT_NO_FATAL_FAILURE(expectAllFree(driver, mode, where));
                if (mode == std::string("D"))
                    driver.shot(("legend-" + where).c_str());
            }
        }
    }
    driver.window().actions()[u"theme-light"_s]->trigger();
    driver.program().setLanguage(u"en"_s);
}

TEST(Legend, TellsUnitAndAreasInARowToo) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Alt+1");
    driver.press("Shift+U");
    PartView& view = driver.window().view();
    const scene::LegendPanel& legend = view.scene().overlay().legend();
    ASSERT_TRUE(driver.waitFor([&] { return legend.words().find("mm or more") != std::string::npos; }));
    scene::Camera near = view.camera();
    near.distance /= 9;
    view.standAt(near);
    const auto shows = [&](const char* words) { return legend.words().find(words) != std::string::npos; };
    ASSERT_TRUE(driver.waitFor([&] { return legend.form() == PanelForm::Row; }));
    EXPECT_TRUE(shows("mm or more")) << legend.words();
    EXPECT_TRUE(shows("cm²")) << legend.words();
}

TEST(Legend, TakesLinesWhereThereIsRoomAndARowBesideALargeShape) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Alt+1");
    driver.press("D");
    PartView& view = driver.window().view();
    const auto form = [&] { return view.scene().overlay().legend().form(); };
    scene::Camera far = view.camera();
    far.distance *= 3;
    view.standAt(far);
    EXPECT_TRUE(driver.waitFor([&] { return form() == PanelForm::Lines; }));
    scene::Camera near = view.camera();
    near.distance /= 9;
    view.standAt(near);
    EXPECT_TRUE(driver.waitFor([&] { return form() == PanelForm::Row; }));
}

// SPDX-License-Identifier: AGPL-3.0-or-later
// The story of the publication's Figure 14, by the events a user makes: an animal with horns that cannot be
// cast, a plane, a run, ears that came out wrong, another plane with pins, another run, a finish.
#include "app/window_driver.h"

#include "panels/picture_list.h"
#include "panels/project_tree.h"
#include "panels/step_button.h"
#include "panels/workflow_bar.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/main_window.h"
#include "window/pin_offers.h"

#include <QApplication>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>

using namespace moldwright;
using namespace Qt::StringLiterals;
using test::WindowDriver;

namespace {

QString verdict(WindowDriver& driver) {
    return driver.window().findChild<VerdictButton*>()->sentence();
}

std::string newestMessage(WindowDriver& driver) {
    return driver.bench().messages()->at(0).text.toStdString();
}

/// Clicks a step of the workflow bar.
void clickStep(WindowDriver& driver, Step step) {
    QTest::mouseClick(driver.window().findChild<WorkflowBar*>()->step(static_cast<int>(step)),
                      Qt::LeftButton);
    QTest::qWait(50);
}

void clickOffered(WindowDriver& driver, int plane) {
    auto* list = driver.window().findChild<PictureList*>(u"pictures-offered"_s);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(plane)).center());
    QTest::qWait(50);
}

/// Tab until the widget of this name has the keyboard.
bool tabTo(const QString& name) {
    for (int presses = 0; presses < 200; ++presses) {
        QWidget* focus = QApplication::focusWidget();
        if (focus && focus->objectName() == name)
            return true;
        QTest::keyClick(focus ? focus : QApplication::activeWindow(), Qt::Key_Tab);
        QTest::qWait(5);
    }
    return false;
}

/// Runs a command by the search: Ctrl+K, its words, Return.
void runByWords(WindowDriver& driver, const QString& words) {
    driver.press("Ctrl+K");
    QTest::keyClicks(QApplication::focusWidget(), words);
    driver.press("Return");
    QTest::qWait(50);
}

/// The ends of horns and ears: those of the suggested pins that are ends of limbs and lie beside the middle.
std::vector<Eigen::Vector3d> hornsAndEars(WindowDriver& driver) {
    std::vector<Eigen::Vector3d> places;
    for (const SuggestedPin& pin : driver.bench().pinOffers().inView())
        if (pin.kind == PinKind::Tip && std::abs(pin.point.x()) > 15)
            places.push_back(pin.point);
    return places;
}

/// The other plane of the shortlist that those lie nearest to: the pictures show which one cuts through them.
int planeThrough(WindowDriver& driver, const std::vector<Eigen::Vector3d>& places) {
    const auto& offered = driver.bench().offeredPlanes();
    int best = 1;
    double least = 1e9;
    for (std::size_t i = 1; i < offered.size(); ++i) {
        double farthest = 0;
        for (const Eigen::Vector3d& place : places)
            farthest = std::max(farthest, std::abs(offered[i].plane.state.plane.distance(place)));
        if (farthest < least) {
            least = farthest;
            best = static_cast<int>(i);
        }
    }
    return best;
}

} // namespace

TEST(Story, OfTheAnimalWithHornsByMouse) {
    WindowDriver driver;
    driver.shot("story-1-start");
    ASSERT_TRUE(driver.openSample("goat_head"));
    EXPECT_EQ(verdict(driver), u"Not castable yet"_s);
    driver.shot("story-2-opened");

    clickStep(driver, Step::Plane);
    driver.click("button-best-plane");
    ASSERT_TRUE(driver.waitIdle());
    driver.shot("story-3-planes");

    clickStep(driver, Step::Deform);
    driver.click("button-run");
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().progress().size() >= 20; }, 180000));
    driver.shot("story-4-running");
    ASSERT_TRUE(driver.waitIdle(400000));
    ASSERT_TRUE(driver.bench().project().cast) << newestMessage(driver);
    driver.shot("story-5-first-cast");
    const SharedMesh first = driver.bench().project().cast->mesh;

    // The ears are not liked: the part comes back, and another plane is tried.
    driver.click("button-restore");
    EXPECT_FALSE(driver.bench().project().cast);
    clickStep(driver, Step::Guides);
    driver.click("button-suggest-pins");
    ASSERT_TRUE(driver.waitIdle());
    const std::vector<Eigen::Vector3d> tips = hornsAndEars(driver);
    ASSERT_EQ(tips.size(), 4U);
    driver.shot("story-6-suggested-pins");
    const int other = planeThrough(driver, tips);
    clickStep(driver, Step::Plane);
    clickOffered(driver, other);
    ASSERT_EQ(driver.bench().offeredPlane(), other);
    clickStep(driver, Step::Guides);
    PartView& view = driver.window().view();
    for (const Eigen::Vector3d& place : tips) {
        QTest::mouseClick(&view, Qt::LeftButton, {}, view.pixelOf(place));
        QTest::qWait(80);
    }
    ASSERT_EQ(driver.bench().project().pins.size(), tips.size());
    driver.shot("story-7-pins");

    clickStep(driver, Step::Deform);
    driver.click("button-run");
    ASSERT_TRUE(
        driver.waitFor([&] { return driver.bench().bending() || !driver.bench().running(); }, 180000));
    if (driver.bench().bending())
        driver.click("button-finish");
    ASSERT_TRUE(driver.waitIdle(400000));
    ASSERT_TRUE(driver.bench().project().cast) << newestMessage(driver);
    EXPECT_EQ(verdict(driver), u"Castable"_s);
    EXPECT_NE(driver.bench().project().cast->mesh, first);
    driver.shot("story-8-castable");
}

TEST(Story, OfTheAnimalWithHornsByKeysAlone) {
    WindowDriver driver;
    ASSERT_TRUE(tabTo(u"sample-goat_head"_s));
    driver.press("Space");
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().project().part != nullptr; }));
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_EQ(verdict(driver), u"Not castable yet"_s);
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(400000));
    ASSERT_TRUE(driver.bench().project().cast) << newestMessage(driver);

    runByWords(driver, u"restore original"_s);
    EXPECT_FALSE(driver.bench().project().cast);
    driver.press("Ctrl+2");
    ASSERT_TRUE(tabTo(u"pictures-offered"_s));
    driver.press("Right");
    EXPECT_EQ(driver.bench().offeredPlane(), 1);
    driver.press("Ctrl+Return");
    ASSERT_TRUE(
        driver.waitFor([&] { return driver.bench().bending() || !driver.bench().running(); }, 180000));
    driver.press("Ctrl+Shift+Return");
    ASSERT_TRUE(driver.waitIdle(400000));
    ASSERT_TRUE(driver.bench().project().cast) << newestMessage(driver);
    EXPECT_EQ(verdict(driver), u"Castable"_s);
    driver.press("Ctrl+M");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_EQ(verdict(driver), u"Castable and opens"_s);
}

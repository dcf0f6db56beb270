// SPDX-License-Identifier: AGPL-3.0-or-later
// The views of the window: how many, what each shows, which one is active, and how they move together.
#include "app/window_driver.h"

#include "support/folders.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/main_window.h"
#include "window/turntable.h"
#include "window/view_area.h"
#include "window/view_pane.h"

#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QListWidget>
#include <QMouseEvent>
#include <QTest>

#include <gtest/gtest.h>

using namespace moldwright;
using test::WindowDriver;

namespace {

/// Whether the view's picture holds more than its ground: a part is drawn in its middle.
bool somethingDrawn(WindowDriver& driver, PartView& view) {
    if (!driver.waitFor([&] { return !view.drawing(); }))
        return false;
    const QImage picture = view.grabFramebuffer();
    const QRgb ground = picture.pixel(picture.width() / 2, picture.height() - 3);
    const QRgb middle = picture.pixel(picture.width() / 2, picture.height() / 2);
    return qAbs(qGray(ground) - qGray(middle)) > 8 || qRed(middle) - qBlue(middle) > 40;
}

PartView& viewAt(WindowDriver& driver, std::size_t number) {
    return driver.window().views().shown().at(number)->view();
}

void chooseInHeader(WindowDriver& driver, const char* field, int row) {
    auto* box = driver.window().findChild<QComboBox*>(QString::fromLatin1(field));
    ASSERT_TRUE(box) << field;
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Home);
    for (int i = 0; i < row; ++i)
        QTest::keyClick(box, Qt::Key_Down);
    QTest::qWait(30);
}

void turnByHand(PartView& view) {
    const QPoint middle(view.width() / 2, view.height() / 2);
    QTest::mousePress(&view, Qt::MiddleButton, Qt::ShiftModifier, middle);
    const QPoint to = middle + QPoint(60, 20);
    QMouseEvent move(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, Qt::MiddleButton,
                     Qt::ShiftModifier);
    QApplication::sendEvent(&view, &move);
    QTest::mouseRelease(&view, Qt::MiddleButton, Qt::ShiftModifier, to);
    QTest::qWait(30);
}

} // namespace

TEST(Views, OneTwoAndFourAllShowThePart) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    const std::vector<std::pair<const char*, std::size_t>> layouts = {
        {"Alt+2", 2}, {"Alt+4", 4}, {"Alt+1", 1}};
    for (const auto& [keys, count] : layouts) {
        driver.press(keys);
        ASSERT_TRUE(driver.waitIdle());
        QTest::qWait(300);
        ASSERT_EQ(driver.window().views().shown().size(), count) << keys;
        for (std::size_t i = 0; i < count; ++i)
            EXPECT_TRUE(somethingDrawn(driver, viewAt(driver, i))) << keys << ", view " << i + 1;
        driver.shot((std::string("30-views-") + std::to_string(count)).c_str());
    }
}

TEST(Views, FourLookFromAboveFrontAndRight) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    driver.press("Alt+4");
    ASSERT_TRUE(driver.waitIdle());
    const auto looksFrom = [&](std::size_t number, const Eigen::Vector3d& from) {
        return viewAt(driver, number).camera().backwards().isApprox(from, 1e-9);
    };
    EXPECT_TRUE(looksFrom(0, Eigen::Vector3d::UnitZ()));
    EXPECT_TRUE(looksFrom(2, -Eigen::Vector3d::UnitY()));
    EXPECT_TRUE(looksFrom(3, Eigen::Vector3d::UnitX()));
    EXPECT_EQ(driver.window().views().shown()[0]->standpoint(), QStringLiteral("Top"));
    EXPECT_EQ(driver.window().views().shown()[1]->standpoint(), QStringLiteral("Free view"));
}

TEST(Views, KeysActOnTheViewThatWasTouchedLast) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    driver.press("Alt+2");
    ASSERT_TRUE(driver.waitIdle());
    const auto mode = [&](std::size_t number) {
        return driver.window().views().shown()[number]->settings().mode;
    };
    QTest::mouseClick(&viewAt(driver, 0), Qt::LeftButton, {}, QPoint(20, 200));
    driver.press("D");
    EXPECT_EQ(mode(0), DisplayMode::DraftMap);
    EXPECT_EQ(mode(1), DisplayMode::Undercuts);
    const auto turn = viewAt(driver, 1).camera().turn;
    driver.press("7");
    ASSERT_TRUE(driver.waitFor(
        [&] { return viewAt(driver, 0).camera().backwards().isApprox(Eigen::Vector3d::UnitZ(), 1e-6); }));
    EXPECT_TRUE(viewAt(driver, 1).camera().turn.isApprox(turn));

    QTest::mouseClick(&viewAt(driver, 1), Qt::LeftButton, {}, QPoint(20, 200));
    driver.press("L");
    EXPECT_EQ(mode(1), DisplayMode::Plain);
    EXPECT_EQ(mode(0), DisplayMode::DraftMap);
    EXPECT_EQ(&driver.window().view(), &viewAt(driver, 1));
    chooseInHeader(driver, "view-1-mode", 0);
    EXPECT_EQ(mode(0), DisplayMode::Undercuts);
    EXPECT_EQ(&driver.window().view(), &viewAt(driver, 0)) << "its header was used";
}

TEST(Views, LinkedViewsMoveTogetherAndOthersDoNot) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    driver.press("Alt+2");
    ASSERT_TRUE(driver.waitIdle());
    const auto turn = [&](std::size_t number) { return viewAt(driver, number).camera().turn; };
    ASSERT_TRUE(turn(0).isApprox(turn(1), 1e-12));
    turnByHand(viewAt(driver, 0));
    EXPECT_FALSE(turn(0).isApprox(turn(1), 1e-6));
    driver.press("Shift+L");
    EXPECT_TRUE(turn(0).isApprox(turn(1), 1e-12)) << "the other one comes at once";
    turnByHand(viewAt(driver, 1));
    EXPECT_TRUE(turn(0).isApprox(turn(1), 1e-12));
    driver.press("Shift+L");
    turnByHand(viewAt(driver, 1));
    EXPECT_FALSE(turn(0).isApprox(turn(1), 1e-6));
}

TEST(Views, ThePartIsSeenBesideItsCastEachWithItsOwnRedFaces) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("bent_beam"));
    const SharedMesh part = driver.bench().project().part;
    driver.press("Alt+2");
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(300000));
    ASSERT_TRUE(driver.bench().castIsProved());
    const auto shownIn = [&](std::size_t number) { return viewAt(driver, number).scene().surface(); };
    ASSERT_TRUE(driver.waitFor([&] { return shownIn(0) && shownIn(0)->mesh == part; }));
    EXPECT_EQ(shownIn(1)->mesh, driver.bench().project().cast->mesh);
    const ShownSurface before = driver.bench().surface(ViewContent::Part);
    ASSERT_TRUE(before.analysis);
    EXPECT_GT(before.analysis->violatingArea, 0);
    EXPECT_EQ(driver.bench().surface(ViewContent::Newest).analysis->violatingArea, 0);
    driver.shot("31-part-and-cast");

    // The other way round, by the header.
    chooseInHeader(driver, "view-1-content", 0);
    ASSERT_TRUE(driver.waitFor([&] { return shownIn(0)->mesh == driver.bench().project().cast->mesh; }));
}

TEST(Views, LayoutAndSettingsAreKeptForTheNextWindow) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    driver.press("Alt+2");
    chooseInHeader(driver, "view-1-mode", 1);
    driver.press("Shift+L");
    driver.program().setLanguage(QStringLiteral("de"));
    QTest::qWait(300);
    const ViewArea& views = driver.window().views();
    EXPECT_EQ(views.viewLayout(), ViewLayout::Two);
    EXPECT_TRUE(views.linked());
    EXPECT_EQ(views.shown()[0]->settings().mode, DisplayMode::DraftMap);
    EXPECT_EQ(views.shown()[0]->settings().content, ViewContent::Part);
    driver.shot("32-german-views");
    driver.window().actions()[QStringLiteral("theme-dark")]->trigger();
    driver.shot("33-dark-views");
    driver.window().actions()[QStringLiteral("theme-light")]->trigger();
    driver.press("Shift+L");
    driver.press("Alt+1");
    driver.program().setLanguage(QStringLiteral("en"));
    QTest::qWait(300);
    EXPECT_EQ(driver.window().views().shown().size(), 1U);
}

TEST(History, AClickGoesBackToThatEditAndForthAgain) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    const Document& document = driver.bench().document();
    std::vector<Project> states = {document.committed()};
    for (const char* edit : {"turn-x", "turn-z", "centre"}) {
        driver.window().actions()[QString::fromLatin1(edit)]->trigger();
        states.push_back(document.committed());
    }
    ASSERT_TRUE(driver.waitIdle());
    auto* list = driver.window().findChild<QListWidget*>(QStringLiteral("history"));
    ASSERT_TRUE(list);
    driver.window().findChild<QDockWidget*>(QStringLiteral("dock-history"))->raise();
    QTest::qWait(100);
    ASSERT_EQ(list->count(), 4);
    driver.shot("70-history");
    for (const int row : {1, 3, 0}) {
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualItemRect(list->item(row)).center());
        QTest::qWait(50);
        EXPECT_EQ(document.history().done(), static_cast<std::size_t>(row));
        EXPECT_TRUE(document.committed() == states[static_cast<std::size_t>(row)]) << row;
        EXPECT_EQ(list->currentRow(), row);
    }
    EXPECT_EQ(document.history().steps().size(), 3U) << "going back takes nothing away";
}

TEST(Pictures, ATurntableGoesOnceAroundAndLeavesTheCameraAlone) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    const test::ScratchFolder folder;
    const QString file = QString::fromStdString((folder.path() / "around.png").string());
    const Eigen::Quaterniond turn = driver.window().view().camera().turn;
    driver.answerFileDialog(file);
    driver.window().actions()[QStringLiteral("turntable")]->trigger();
    ASSERT_TRUE(driver.waitFor([&] { return QFile::exists(file); }, 120000));
    EXPECT_TRUE(driver.window().view().camera().turn.isApprox(turn, 1e-12));
    QFile written(file);
    ASSERT_TRUE(written.open(QIODevice::ReadOnly));
    const QByteArray bytes = written.readAll();
    EXPECT_EQ(bytes.count("fcTL"), Turntable::pictures);
    EXPECT_EQ(QImage::fromData(bytes).size(), driver.window().view().grabFramebuffer().size());
}

TEST(Pictures, AScreenshotIsTheActiveView) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Alt+2");
    ASSERT_TRUE(driver.waitIdle());
    const test::ScratchFolder folder;
    const QString file = QString::fromStdString((folder.path() / "view.png").string());
    driver.answerFileDialog(file);
    driver.window().actions()[QStringLiteral("screenshot")]->trigger();
    ASSERT_TRUE(driver.waitFor([&] { return QFile::exists(file); }));
    EXPECT_EQ(QImage(file).size(), driver.window().view().grabFramebuffer().size());
    driver.press("Alt+1");
}

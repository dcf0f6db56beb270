// SPDX-License-Identifier: AGPL-3.0-or-later
// Edits of the document through the real window: by grips, fields, keys, undo and redo, files.
#include "app/window_driver.h"

#include "mesh/measures.h"
#include "panels/command_search.h"
#include "panels/workflow_bar.h"
#include "project/placing.h"
#include "project/project_file.h"
#include "scene/direction_handle.h"
#include "support/folders.h"
#include "support/shapes.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/main_window.h"

#include <QApplication>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMouseEvent>
#include <QTest>

#include <gtest/gtest.h>

using namespace moldwright;
using test::WindowDriver;

namespace {

void drag(PartView& view, QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton,
          Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(&view, button, keys, from);
    for (int step = 1; step <= 8; ++step) {
        const QPoint at = from + (to - from) * step / 8;
        QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, button, keys);
        QApplication::sendEvent(&view, &move);
        QTest::qWait(10);
    }
    QTest::mouseRelease(&view, button, keys, to);
    QTest::qWait(20);
}

} // namespace

TEST(Editing, DraggingTheGripMovesThePlaneInOneUndoStepAndTheRedFacesFollow) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    PartView& view = driver.window().view();
    const MoldState before = *driver.bench().project().state;
    const double areaBefore = driver.bench().analysis()->analysis.violatingArea;
    const QPoint grip = view.gripPixel(scene::Grip::SlidePlane);
    drag(view, grip, grip + QPoint(0, -60));
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_GT(driver.bench().project().state->plane.offset, before.plane.offset + 1);
    EXPECT_NE(driver.bench().analysis()->analysis.violatingArea, areaBefore);
    EXPECT_EQ(driver.bench().document().history().steps().size(), 1U);
    driver.press("Ctrl+Z");
    EXPECT_EQ(*driver.bench().project().state, before);
    driver.press("Ctrl+Shift+Z");
    EXPECT_NE(*driver.bench().project().state, before);
}

TEST(Editing, TheTitleIsTypedOnThePartsPage) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.selectRow("part");
    const auto write = [&](const char* field, const char* words) {
        auto* line = driver.window().findChild<QLineEdit*>(QString::fromLatin1(field));
        ASSERT_NE(line, nullptr) << field;
        line->setFocus();
        line->selectAll();
        QTest::keyClicks(line, QString::fromUtf8(words));
        QTest::keyClick(line, Qt::Key_Return);
        QTest::qWait(30);
    };
    write("text-part-number", "M-1042");
    write("text-part-revision", "B");
    write("text-part-name", "Rose praline");
    const Project& project = driver.bench().project();
    EXPECT_EQ(project.number + project.revision + project.name, "M-1042BRose praline");
    EXPECT_TRUE(driver.window().windowTitle().contains(QStringLiteral("Rose praline")));
    driver.shot("part-title");
    driver.press("Ctrl+Z");
    EXPECT_EQ(driver.bench().project().name, "Praline");
    EXPECT_EQ(driver.bench().document().history().steps().size(), 3U) << "a step each";
}

TEST(Editing, DraggingAnArrowTurnsItsDirectionInOneUndoStepAndARunTakesItAsItIs) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    PartView& view = driver.window().view();
    const Project before = driver.bench().document().committed();
    const double areaBefore = driver.bench().analysis()->analysis.violatingArea;
    const QPoint tip = view.gripPixel(scene::Grip::Direction1);
    drag(view, tip, tip + QPoint(45, 5));
    ASSERT_TRUE(driver.waitIdle());
    const Project after = driver.bench().document().committed();
    EXPECT_GT(scene::leanOf(*after.state, 1).tiltDegrees, 2);
    EXPECT_EQ(after.state->directions.d2, before.state->directions.d2);
    EXPECT_EQ(after.state->plane, before.state->plane);
    EXPECT_EQ(after.design.directionsChoice, DirectionsChoice::Given);
    EXPECT_NE(driver.bench().analysis()->analysis.violatingArea, areaBefore);
    EXPECT_EQ(driver.bench().document().history().steps().size(), 1U);
    driver.shot("15-direction");
    driver.press("Ctrl+Z");
    EXPECT_TRUE(driver.bench().document().committed() == before);
}

TEST(Editing, EscapeGivesUpADragOfAnArrow) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    PartView& view = driver.window().view();
    const MoldState before = *driver.bench().project().state;
    const QPoint tip = view.gripPixel(scene::Grip::Direction1);
    QTest::mousePress(&view, Qt::LeftButton, {}, tip);
    const QPoint to = tip + QPoint(60, 0);
    QMouseEvent move(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&view, &move);
    EXPECT_NE(*driver.bench().project().state, before);
    driver.press("Esc");
    QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
    EXPECT_EQ(*driver.bench().project().state, before);
    EXPECT_TRUE(driver.bench().document().history().steps().empty());
}

TEST(Editing, ADirectionIsTypedAsTiltAndWay) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.selectRow("direction-2");
    driver.type("field-lean2", "12.5");
    driver.type("field-way2", "90");
    const scene::Lean lean = scene::leanOf(*driver.bench().project().state, 2);
    EXPECT_NEAR(lean.tiltDegrees, 12.5, 1e-9);
    EXPECT_NEAR(lean.wayDegrees, 90, 1e-9);
    EXPECT_EQ(driver.bench().project().design.directionsChoice, DirectionsChoice::Given);
    driver.shot("16-direction-page");
}

TEST(Editing, TheLeftButtonNeverOrbitsAndTheMiddleButtonFollowsTheScheme) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    PartView& view = driver.window().view();
    const auto turn = view.camera().turn;
    const auto focus = view.camera().focus;
    const QPoint middle(view.width() / 2, view.height() / 2);
    drag(view, QPoint(20, 120), middle);
    EXPECT_TRUE(view.camera().turn.isApprox(turn));
    EXPECT_TRUE(view.camera().focus.isApprox(focus));
    drag(view, middle, middle + QPoint(50, 10), Qt::MiddleButton);
    EXPECT_TRUE(view.camera().turn.isApprox(turn));
    EXPECT_FALSE(view.camera().focus.isApprox(focus, 1e-6));
    drag(view, middle, middle + QPoint(50, 10), Qt::MiddleButton, Qt::ShiftModifier);
    EXPECT_FALSE(view.camera().turn.isApprox(turn, 1e-6));
}

TEST(Editing, TypingALengthScalesThePart) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.type("field-size", "2 in");
    EXPECT_NEAR(boundingBox(*driver.bench().project().part).sizes().maxCoeff(), 50.8, 0.01);
}

TEST(Editing, ThePartIsTurnedByAnyAngleSeenBeforeItIsDone) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    const SharedMesh before = driver.bench().project().part;
    driver.press("R");
    driver.type("turn-angle", "30"); // Return in the field accepts
    ASSERT_TRUE(driver.waitIdle());
    const Document& document = driver.bench().document();
    ASSERT_EQ(document.history().steps().size(), 1U);
    const Eigen::Isometry3d turn = turnAbout(*before, Eigen::Vector3d::UnitZ(), 30);
    EXPECT_LT((document.committed().part->point(7) - turn * before->point(7)).norm(), 1e-9);

    driver.press("R");
    auto* angle = driver.window().findChild<QDoubleSpinBox*>(QStringLiteral("turn-angle"));
    ASSERT_TRUE(angle);
    angle->setValue(45);
    EXPECT_NE(document.project().part, document.committed().part) << "seen while it is asked for";
    driver.shot("17-turn");
    driver.press("Esc");
    EXPECT_EQ(document.project().part, document.committed().part);
    EXPECT_EQ(document.history().steps().size(), 1U);
}

TEST(Editing, ACommandIsFoundByItsWords) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Ctrl+K");
    auto* search = driver.window().findChild<CommandSearch*>();
    ASSERT_TRUE(search->hasFocus());
    QTest::keyClicks(search, QStringLiteral("turn z"));
    QTest::keyClick(search, Qt::Key_Return);
    EXPECT_EQ(driver.bench().document().history().steps().size(), 1U);
}

TEST(Editing, AProjectSavedAndOpenedIsTheSame) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.window().actions()[QStringLiteral("turn-x")]->trigger();
    const Project before = driver.bench().document().committed();
    const test::ScratchFolder folder;
    const QString file = QString::fromStdString((folder.path() / "praline.moldwright").string());
    driver.answerFileDialog(file);
    driver.press("Ctrl+S");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_FALSE(driver.bench().document().isChanged());
    QAction* close = driver.window().actions()[QStringLiteral("start-page")];
    ASSERT_TRUE(driver.waitFor([&] { return close->isEnabled(); }));
    close->trigger();
    ASSERT_FALSE(driver.bench().project().part);
    driver.window().openPath(file);
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().project().part != nullptr; }));
    const Project& after = driver.bench().project();
    EXPECT_EQ(after.part->V, before.part->V);
    EXPECT_EQ(after.state, before.state);
    EXPECT_EQ(after.name, before.name);
}

TEST(Editing, ThemeAndLanguageChangeAtRunTime) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("goat_head"));
    driver.window().actions()[QStringLiteral("theme-dark")]->trigger();
    driver.shot("10-dark");
    EXPECT_LT(QApplication::palette().color(QPalette::Window).lightness(), 80);
    driver.program().setLanguage(QStringLiteral("de"));
    QTest::qWait(300);
    EXPECT_EQ(driver.window().actions()[QStringLiteral("undo")]->text(), QStringLiteral("&Rückgängig"));
    EXPECT_TRUE(driver.bench().project().part);
    driver.shot("11-german");
    driver.program().setLanguage(QStringLiteral("en"));
    driver.window().actions()[QStringLiteral("theme-light")]->trigger();
    driver.window().actions()[QStringLiteral("show-draft")]->trigger();
    driver.shot("12-draft-map");
    driver.window().resize(1100, 720);
    driver.shot("13-small");
}

TEST(Editing, ALargeMeshHasAStandInForMovementsThatTellsTheSame) {
    WindowDriver driver;
    const test::ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "ball.ply";
    ASSERT_TRUE(writeMesh(file, test::sphere({0, 0, 0}, 30, 7), MeshFormat::Ply));
    ASSERT_TRUE(driver.openMesh(QString::fromStdString(file.string()), 60));
    const AnalysisAnswer& answer = *driver.bench().analysis();
    ASSERT_TRUE(answer.drawn->standIn);
    EXPECT_LT(answer.drawn->standIn->mesh->faceCount(), driver.bench().project().part->faceCount() / 2);
    EXPECT_NEAR(answer.standInAnalysis.violatingAreaFraction, answer.analysis.violatingAreaFraction, 0.02);
    PartView& view = driver.window().view();
    const auto wholeInView = [&] { return !view.drawing() && !view.scene().standInsUsed(); };
    ASSERT_TRUE(driver.waitFor(wholeInView));
    const QImage whole = view.grabFramebuffer();
    EXPECT_EQ(whole, view.grabFramebuffer()) << "the picture in view is the finished one";

    // While the plane is dragged the red faces follow on the stand-in, from release on exactly.
    const QPoint grip = view.gripPixel(scene::Grip::SlidePlane);
    QTest::mousePress(&view, Qt::LeftButton, {}, grip);
    QMouseEvent move(QEvent::MouseMove, grip + QPoint(0, -70), view.mapToGlobal(grip + QPoint(0, -70)),
                     Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&view, &move);
    ASSERT_TRUE(driver.waitFor([&] {
        return driver.bench().analysisIsCoarse() &&
               driver.bench().analysis()->request.state == driver.bench().project().state;
    }));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, grip + QPoint(0, -70));
    ASSERT_TRUE(driver.waitIdle());
    ASSERT_TRUE(driver.waitFor(wholeInView));
    EXPECT_NE(view.grabFramebuffer(), whole);

    driver.answerQuestion("leave-discard");
    driver.window().actions()[QStringLiteral("start-page")]->trigger();
    ASSERT_TRUE(driver.openSample("praline"));
    EXPECT_FALSE(view.scene().surface()->standIn);
}

TEST(Leaving, SavingOnTheWayOutSavesAndThenCloses) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.window().actions()[QStringLiteral("turn-x")]->trigger();
    const test::ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "left.moldwright";
    driver.answerQuestion("leave-save");
    driver.answerFileDialog(QString::fromStdString(file.string()));
    driver.press("Ctrl+Q");
    ASSERT_TRUE(driver.waitFor([&] { return !driver.window().isVisible(); }));
    const Result<StoredProject> saved = openProject(file);
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->project.part->V, driver.bench().project().part->V);
}

TEST(Leaving, SavingOnTheWayToAnotherFileSavesAndThenOpensIt) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    const test::ScratchFolder folder;
    const QString first = QString::fromStdString((folder.path() / "first.moldwright").string());
    const QString second = QString::fromStdString((folder.path() / "second.moldwright").string());
    driver.answerFileDialog(first);
    driver.press("Ctrl+S");
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().document().file() == first; }));
    ASSERT_TRUE(driver.waitIdle());
    driver.window().actions()[QStringLiteral("turn-x")]->trigger();
    driver.answerFileDialog(second);
    driver.press("Ctrl+Shift+S");
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().document().file() == second; }));
    ASSERT_TRUE(driver.waitIdle());
    driver.window().actions()[QStringLiteral("turn-z")]->trigger();
    const Points turned = driver.bench().project().part->V;
    driver.answerQuestion("leave-save");
    driver.window().openPath(first);
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().document().file() == first; }));
    const Result<StoredProject> saved = openProject(second.toStdString());
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->project.part->V, turned);
}

TEST(Leaving, KeepingItOpenKeepsItAndGivingUpClosesIt) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.window().actions()[QStringLiteral("turn-x")]->trigger();
    driver.answerQuestion("leave-stay");
    driver.press("Ctrl+Q");
    EXPECT_TRUE(driver.window().isVisible());
    EXPECT_TRUE(driver.bench().document().isChanged());
    driver.answerQuestion("leave-discard");
    driver.press("Ctrl+W");
    EXPECT_TRUE(driver.waitFor([&] { return !driver.bench().project().part; }));
}

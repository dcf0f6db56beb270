// SPDX-License-Identifier: AGPL-3.0-or-later
// Several designs of one part, through the real window: made, worked on, compared, chosen, saved.
#include "app/window_driver.h"

#include "panels/figure_table.h"
#include "panels/project_tree.h"
#include "panels/property_panel.h"
#include "project/variants.h"
#include "support/folders.h"
#include "theme/theme.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/main_window.h"
#include "window/view_area.h"
#include "window/view_pane.h"

#include <QApplication>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QTest>
#include <QTimer>

#include <gtest/gtest.h>

using namespace moldwright;
using namespace Qt::StringLiterals;
using test::WindowDriver;

namespace {

const Project& project(WindowDriver& driver) {
    return driver.bench().document().committed();
}

FigureTable* table(WindowDriver& driver) {
    return driver.window().findChild<FigureTable*>(u"table-variants"_s);
}

QString cell(WindowDriver& driver, int row, int column) {
    return table(driver)->item(row, column)->text();
}

/// The middle of a tree's row, for a click.
QPoint rowPlace(ProjectTree& tree, const char* id) {
    const auto* model = qobject_cast<ProjectModel*>(tree.model());
    return tree.visualRect(model->indexOf(QString::fromLatin1(id))).center();
}

ProjectTree& tree(WindowDriver& driver) {
    return *driver.window().findChild<ProjectTree*>();
}

/// A sample with two casts: A, and B with more draft.
void makeTwo(WindowDriver& driver) {
    ASSERT_TRUE(driver.openSample("bent_beam"));
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(180000));
    ASSERT_TRUE(project(driver).cast);
    driver.press("Ctrl+D");
    ASSERT_EQ(variantCount(project(driver)), 2U);
    driver.press("Ctrl+4");
    driver.type("field-draft", "4");
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(180000));
    ASSERT_TRUE(project(driver).cast);
    ASSERT_NE(project(driver).cast, variantAt(project(driver), 0).cast);
}

bool figuresKnown(WindowDriver& driver) {
    return driver.waitFor([&] {
        for (std::size_t i = 0; i < variantCount(project(driver)); ++i)
            if (variantAt(project(driver), i).cast && !driver.bench().variants().figures(i))
                return false;
        return true;
    });
}

} // namespace

TEST(VariantsWindow, ADuplicateIsWorkedOnWhileTheOtherStaysAsItIs) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.selectRow("variants");
    EXPECT_EQ(table(driver)->columnCount(), 1);
    const Project before = project(driver);
    driver.click("button-duplicate-variant");
    ASSERT_EQ(variantCount(project(driver)), 2U);
    EXPECT_EQ(project(driver).variantName, "B");
    EXPECT_EQ(table(driver)->columnCount(), 2);
    EXPECT_EQ(cell(driver, 0, 0), u"not run"_s);
    driver.press("Shift+X");
    EXPECT_NE(project(driver).state, before.state);
    EXPECT_EQ(variantAt(project(driver), 0).state, before.state);
    // There and back by keys; each is a step.
    driver.press("Ctrl+PgUp");
    EXPECT_EQ(project(driver).variantName, "A");
    EXPECT_EQ(project(driver).state, before.state);
    driver.press("Ctrl+PgDown");
    EXPECT_EQ(project(driver).variantName, "B");
    for (int i = 0; i < 4; ++i)
        driver.press("Ctrl+Z");
    EXPECT_EQ(project(driver), before);
    for (int i = 0; i < 4; ++i)
        driver.press("Ctrl+Shift+Z");
    EXPECT_EQ(project(driver).variantName, "B");
}

TEST(VariantsWindow, AreRenamedChosenAndRemovedInTheTree) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Ctrl+D");
    driver.press("Ctrl+Shift+N");
    ASSERT_EQ(variantNames(project(driver)), "A, B, C");
    // F2 and a name; one that another has is refused with a message.
    driver.selectRow("variant-1");
    driver.press("F2");
    auto* editor = tree(driver).findChild<QLineEdit*>();
    ASSERT_TRUE(editor);
    editor->selectAll();
    QTest::keyClicks(editor, u"flat back"_s);
    QTest::keyClick(editor, Qt::Key_Return);
    QTest::qWait(50);
    EXPECT_EQ(variantNames(project(driver)), "A, flat back, C");
    const int messages = driver.bench().messages()->rowCount();
    driver.bench().renameVariant(0, u"C"_s);
    EXPECT_EQ(variantNames(project(driver)), "A, flat back, C");
    EXPECT_GT(driver.bench().messages()->rowCount(), messages);
    // Return takes the one that is chosen, a double click too.
    tree(driver).setFocus();
    QTest::keyClick(&tree(driver), Qt::Key_Return);
    EXPECT_EQ(project(driver).variantName, "flat back");
    QTest::qWait(50);
    const QPoint first = rowPlace(tree(driver), "variant-0");
    QTest::mouseClick(tree(driver).viewport(), Qt::LeftButton, {}, first);
    QTest::mouseDClick(tree(driver).viewport(), Qt::LeftButton, {}, first);
    EXPECT_EQ(project(driver).variantName, "A");
    // Del removes the one that is chosen, and is one step.
    driver.selectRow("variant-2");
    driver.press("Del");
    EXPECT_EQ(variantNames(project(driver)), "A, flat back");
    driver.press("Ctrl+Z");
    EXPECT_EQ(variantNames(project(driver)), "A, flat back, C");
}

TEST(VariantsWindow, TheMenuOfARowIsForThatRow) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Ctrl+D");
    QTest::qWait(50);
    QStringList seen;
    QTimer::singleShot(300, [&] {
        if (auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) {
            for (const QAction* action : menu->actions())
                if (!action->isSeparator() && action->isEnabled())
                    seen << action->objectName();
            for (QAction* action : menu->actions())
                if (action->objectName() == u"choose-variant"_s) {
                    menu->setActiveAction(action);
                    QTest::keyClick(menu, Qt::Key_Return);
                }
        }
    });
    const QPoint place = rowPlace(tree(driver), "variant-0");
    QContextMenuEvent event(QContextMenuEvent::Mouse, place, tree(driver).viewport()->mapToGlobal(place));
    QApplication::sendEvent(tree(driver).viewport(), &event);
    EXPECT_EQ(seen, (QStringList{u"choose-variant"_s, u"compare-variants"_s, u"duplicate-variant"_s,
                                 u"new-variant"_s, u"rename"_s, u"remove-guide"_s}));
    EXPECT_EQ(project(driver).variantName, "A");
}

TEST(VariantsWindow, AreComparedSideBySideWithOneScale) {
    WindowDriver driver;
    makeTwo(driver);
    driver.selectRow("variants");
    ASSERT_TRUE(figuresKnown(driver));
    QTest::qWait(50);
    EXPECT_EQ(cell(driver, 0, 0), u"yes"_s);
    EXPECT_EQ(cell(driver, 0, 1), u"yes"_s);
    EXPECT_NE(cell(driver, 1, 0), cell(driver, 1, 1)); // drafts of 1° and 4°
    EXPECT_NE(cell(driver, 6, 0), u"–"_s);
    EXPECT_NE(cell(driver, 7, 0), u"–"_s);
    // A click in the table chooses a variant, whose row the tree has too.
    QTest::mouseClick(table(driver)->viewport(), Qt::LeftButton, {},
                      table(driver)->visualItemRect(table(driver)->item(2, 0)).center());
    EXPECT_EQ(tree(driver).selectedId(), u"variant-0"_s);
    driver.press("Ctrl+Shift+D");
    ViewArea& views = driver.window().views();
    ASSERT_EQ(views.shown().size(), 2U);
    EXPECT_EQ(views.shown()[1]->settings().content, ViewContent::Compared);
    const auto map = [&](ViewContent content) {
        return driver.bench().map(content, DisplayMode::Difference);
    };
    ASSERT_TRUE(
        driver.waitFor([&] { return map(ViewContent::Newest) && map(ViewContent::Compared); }, 60000));
    EXPECT_EQ(map(ViewContent::Newest)->scale.step, map(ViewContent::Compared)->scale.step);
    EXPECT_GT(map(ViewContent::Newest)->largest, 0);
    EXPECT_EQ(map(ViewContent::Compared)->request.surface, variantAt(project(driver), 0).cast->mesh);
    // Both views move together.
    views.shown()[0]->view().lookFrom(Eigen::Vector3d::UnitX());
    QTest::qWait(600);
    EXPECT_TRUE(
        views.shown()[1]->view().camera().turn.isApprox(views.shown()[0]->view().camera().turn, 1e-6));
    driver.press("0");
    QTest::qWait(600);
    driver.shot("variants-compared");
    // Made current, it is compared with the one that was.
    driver.press("Ctrl+PgUp");
    EXPECT_EQ(driver.bench().variants().compared(), std::size_t{1});
    driver.press("Esc");
    EXPECT_FALSE(driver.bench().variants().compared());
    EXPECT_EQ(views.viewLayout(), ViewLayout::One);
}

TEST(VariantsWindow, WhatIsNotRunSaysSoAndCanStillBeCompared) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Ctrl+D");
    driver.press("Shift+X");
    driver.press("Ctrl+Shift+D");
    ASSERT_TRUE(driver.waitFor([&] {
        return driver.bench().surface(ViewContent::Compared).drawn &&
               driver.window().views().shown().size() == 2;
    }));
    EXPECT_EQ(driver.bench().stateIn(ViewContent::Compared), variantAt(project(driver), 0).state);
    EXPECT_NE(driver.bench().stateIn(ViewContent::Compared), driver.bench().shownState());
    QTest::qWait(300);
    driver.shot("variants-not-run");
    // What is compared may go: then one view is left as it was.
    driver.press("Ctrl+Z");
    driver.press("Ctrl+Z");
    QTest::qWait(100);
    EXPECT_EQ(driver.window().views().viewLayout(), ViewLayout::One);
    EXPECT_FALSE(driver.bench().variants().compared());
}

TEST(VariantsWindow, AreInTheFile) {
    const test::ScratchFolder folder;
    const QString file = QString::fromStdString((folder.path() / "two.moldwright").string());
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Ctrl+D");
    driver.press("Shift+X");
    driver.bench().save(file, {});
    ASSERT_TRUE(driver.waitIdle());
    const std::optional<MoldState> state = project(driver).state;
    driver.bench().openFile(file);
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_EQ(variantNames(project(driver)), "A, B");
    EXPECT_EQ(project(driver).variantName, "B");
    EXPECT_EQ(project(driver).state, state);
    EXPECT_FALSE(driver.bench().document().history().canUndo());
}

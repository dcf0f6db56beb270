// SPDX-License-Identifier: AGPL-3.0-or-later
// Different parts in one mold, through the real window: added, counted, built, undone, saved, read again.
#include "app/window_driver.h"

#include "castability/certificate.h"
#include "panels/banner.h"
#include "panels/message_list.h"
#include "panels/project_tree.h"
#include "panels/property_panel.h"
#include "project/edits.h"
#include "project/project_file.h"
#include "support/casts.h"
#include "support/folders.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/main_window.h"
#include "window/mold_placing.h"
#include "window/tray_pages.h"
#include "window/workbench.h"

#include <QComboBox>
#include <QFile>
#include <QTest>

#include <gtest/gtest.h>

using namespace moldwright;
using namespace Qt::StringLiterals;
using test::WindowDriver;

namespace {

const Project& project(WindowDriver& driver) {
    return driver.bench().document().committed();
}

/// A sample that was run with directions along the normal, which all casts can share.
void designed(WindowDriver& driver, const char* sample) {
    ASSERT_TRUE(driver.openSample(sample));
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    driver.selectRow("plane");
    auto* directions = driver.window().findChild<QComboBox*>(u"choice-choice"_s);
    ASSERT_NE(directions, nullptr);
    directions->setFocus();
    QTest::keyClick(directions, Qt::Key_Down); // along the normal
    ASSERT_EQ(project(driver).design.directionsChoice, DirectionsChoice::Normal);
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(180000));
    ASSERT_TRUE(driver.bench().castIsProved());
}

void save(WindowDriver& driver, const QString& file) {
    driver.answerFileDialog(file);
    driver.press("Ctrl+S");
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().document().file() == file; }));
    ASSERT_TRUE(driver.waitIdle());
}

void add(WindowDriver& driver, const QString& file) {
    driver.answerFileDialog(file);
    driver.press("Ctrl+Shift+M");
    ASSERT_TRUE(driver.waitIdle());
}

/// A project file whose cast is the part itself.
QString projectOf(const test::ScratchFolder& folder, const char* name, const test::KnownCast& cast) {
    const auto mesh = std::make_shared<const IndexedMesh>(cast.mesh);
    DesignResult result;
    result.cast = mesh;
    result.labels = labelSides(cast.mesh, cast.state.plane);
    result.state = cast.state;
    const std::filesystem::path file = folder.path() / (std::string(name) + ".moldwright");
    EXPECT_TRUE(saveProject(file, {withCast(withPart({}, name, "", mesh, {}), result, 1), "", ""}));
    return QString::fromStdString(file.string());
}

const ProjectRow* row(WindowDriver& driver, const char* id) {
    const auto* model = qobject_cast<ProjectModel*>(driver.window().findChild<ProjectTree*>()->model());
    const QModelIndex index = model->indexOf(QString::fromLatin1(id));
    return index.isValid() ? &model->row(index) : nullptr;
}

QString page(WindowDriver& driver) {
    return driver.window().findChild<PropertyPanel*>()->pageId();
}

std::size_t steps(WindowDriver& driver) {
    return driver.bench().document().history().done();
}

} // namespace

TEST(TrayWindow, APartIsAddedCountedBuiltUndoneSavedAndOpenedAgain) {
    const test::ScratchFolder folder;
    const QString beam = QString::fromStdString((folder.path() / "beam.moldwright").string());
    WindowDriver driver;
    ASSERT_NO_FATAL_FAILURE(designed(driver, "bent_beam"));
    ASSERT_NO_FATAL_FAILURE(save(driver, beam));
    driver.window().actions()[u"start-page"_s]->trigger();
    ASSERT_NO_FATAL_FAILURE(designed(driver, "praline"));
    const Project alone = project(driver);
    driver.selectRow("mold");
    EXPECT_EQ(row(driver, "tray-0"), nullptr) << "one part needs no list";
    const std::size_t before = steps(driver);

    ASSERT_NO_FATAL_FAILURE(add(driver, beam));
    ASSERT_EQ(project(driver).furtherParts.size(), 1U);
    EXPECT_EQ(steps(driver), before + 1);
    EXPECT_EQ(page(driver), u"tray-1"_s) << "what was added is chosen";
    driver.type("field-tray-count-1", "2");
    EXPECT_EQ(project(driver).furtherParts[0].count, 2);
    ASSERT_TRUE(row(driver, "tray-0") && row(driver, "tray-1"));
    EXPECT_EQ(row(driver, "tray-0")->value, u"×1"_s);
    EXPECT_EQ(row(driver, "tray-1")->value, u"×2"_s);
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().placing().sketch() != nullptr; }))
        << driver.bench().placing().refusal().toStdString();
    EXPECT_EQ(driver.bench().placing().sketch()->partingLines.size(), 3U) << "live, before it is built";
    driver.window().view().setFocus();
    driver.press("F"); // what is chosen, also beside the part
    driver.shot("tray-part");

    driver.window().setFocus();
    driver.press("Ctrl+M");
    ASSERT_TRUE(driver.waitIdle(180000));
    ASSERT_TRUE(driver.bench().mold());
    EXPECT_TRUE(driver.bench().mold()->verified());
    ASSERT_EQ(driver.bench().mold()->parts.size(), 2U);
    EXPECT_EQ(driver.bench().mold()->parts[1].cavities, 2);
    EXPECT_EQ(driver.bench().mold()->cavities, 3);
    EXPECT_TRUE(driver.bench().moldIsCurrent());
    driver.selectRow("mold");
    EXPECT_EQ(trayWords(driver.bench()).toStdString(),
              "3 cavities: 1 × " + alone.name + ", 2 × " + project(driver).furtherParts[0].name);
    QTest::qWait(900); // it opens
    driver.shot("tray-mold");
    driver.type("field-tray-count-1", "3");
    EXPECT_FALSE(driver.bench().moldIsCurrent());
    driver.type("field-tray-count-1", "2");
    EXPECT_TRUE(driver.bench().moldIsCurrent()) << "as it was built";
    driver.window().setFocus();
    driver.press("Ctrl+Z"); // what was typed into one field is one step
    EXPECT_EQ(project(driver).furtherParts[0].count, 1);
    EXPECT_EQ(steps(driver), before + 1);
    driver.press("Ctrl+Shift+Z");
    EXPECT_EQ(project(driver).furtherParts[0].count, 2);

    // Removed by a key, and back by one step.
    const Project two = project(driver);
    driver.selectRow("tray-1");
    driver.press("Del");
    EXPECT_EQ(project(driver), alone);
    EXPECT_EQ(row(driver, "tray-0"), nullptr);
    EXPECT_FALSE(driver.bench().moldIsCurrent());
    driver.press("Ctrl+Z");
    EXPECT_EQ(project(driver), two);

    const QString file = QString::fromStdString((folder.path() / "both.moldwright").string());
    ASSERT_NO_FATAL_FAILURE(save(driver, file));
    driver.window().actions()[u"start-page"_s]->trigger();
    driver.window().openPath(file);
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().project().part != nullptr; }));
    ASSERT_TRUE(driver.waitIdle());
    ASSERT_EQ(project(driver).furtherParts.size(), 1U);
    EXPECT_EQ(project(driver).furtherParts[0].count, 2);
    EXPECT_EQ(project(driver).furtherParts[0].cast->mesh->V, two.furtherParts[0].cast->mesh->V);
    EXPECT_EQ(QString::fromStdString(project(driver).furtherParts[0].source), beam);
    driver.window().actions()[u"theme-dark"_s]->trigger();
    driver.selectRow("tray-1");
    QTest::qWait(500);
    driver.shot("tray-dark");
    driver.window().actions()[u"theme-light"_s]->trigger();
}

TEST(TrayWindow, APartIsReadAgainFromItsFile) {
    const test::ScratchFolder folder;
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    const QString file = projectOf(folder, "bar", test::frusta(30, 16, 5, 3, 0.1));
    ASSERT_NO_FATAL_FAILURE(add(driver, file)); // before there is a cast, too
    ASSERT_EQ(project(driver).furtherParts.size(), 1U);
    const std::size_t before = steps(driver);
    driver.click("button-read-part-again");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_EQ(steps(driver), before) << "it is the same";
    projectOf(folder, "bar", test::frusta(20, 16, 5, 3, 0.1));
    driver.click("button-read-part-again");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_EQ(steps(driver), before + 1);
    EXPECT_EQ(project(driver).furtherParts[0].cast->mesh->V.col(0).maxCoeff(), 10);
    const Project newer = project(driver);
    QFile::remove(file);
    driver.click("button-read-part-again");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_EQ(project(driver), newer);
    EXPECT_TRUE(driver.window().findChild<Banner*>()->isVisible()) << "why not";
}

TEST(TrayWindow, WhatCannotBeAddedOrCannotStandThereIsTold) {
    const test::ScratchFolder folder;
    WindowDriver driver;
    ASSERT_NO_FATAL_FAILURE(designed(driver, "praline"));
    const Project alone = project(driver);
    auto* banner = driver.window().findChild<Banner*>();
    const std::filesystem::path raw = folder.path() / "raw.moldwright";
    ASSERT_TRUE(saveProject(raw, {withPins(alone, {{{{1, 2, 3}}, {}}}), "", ""}));
    ASSERT_NO_FATAL_FAILURE(add(driver, QString::fromStdString(raw.string())));
    EXPECT_EQ(project(driver), alone);
    EXPECT_TRUE(banner->isVisible());
    driver.click("banner-close");

    ASSERT_NO_FATAL_FAILURE(
        add(driver, projectOf(folder, "steep", test::sheared(test::ball(6, 4), 0.4, 0.4))));
    ASSERT_EQ(project(driver).furtherParts.size(), 1U);
    ASSERT_TRUE(driver.waitFor([&] { return !driver.bench().placing().refusal().isEmpty(); }));
    EXPECT_TRUE(trayWords(driver.bench()).contains(u"steep"_s)) << trayWords(driver.bench()).toStdString();
    ASSERT_TRUE(banner->isVisible());
    driver.shot("tray-refused");
    // The banner offers the way back.
    driver.click("banner-action");
    EXPECT_EQ(project(driver), alone);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
// Meshes that cannot be designed with, through the real window.
#include "app/document_hash.h"
#include "app/window_driver.h"

#include "exchange/mesh_file.h"
#include "mesh/measures.h"
#include "panels/banner.h"
#include "panels/project_tree.h"
#include "support/folders.h"
#include "support/shapes.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/main_window.h"
#include "window/refused_mesh.h"

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QTest>

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

using namespace moldwright;
using test::WindowDriver;

namespace {

/// A box 30 mm long and a ball, with a hole in each; the box's is the wider.
IndexedMesh withTwoHoles() {
    IndexedMesh mesh = test::together(test::box({0, 0, 0}, {30, 20, 20}), test::sphere({50, 10, 10}, 10, 3));
    mesh.F = mesh.F.bottomRows(mesh.F.rows() - 2).eval(); // one of the box's sides
    mesh.F.conservativeResize(mesh.F.rows() - 1, 3);      // a face of the ball
    return mesh;
}

IndexedMesh crossing() {
    return test::together(test::sphere({0, 0, 0}, 10, 3), test::sphere({12, 0, 0}, 10, 3));
}

QString written(const test::ScratchFolder& folder, const char* name, const IndexedMesh& mesh) {
    const std::filesystem::path file = folder.path() / name;
    EXPECT_TRUE(writeMesh(file, mesh, MeshFormat::Ply));
    return QString::fromStdString(file.string());
}

bool openRefused(WindowDriver& driver, const QString& file) {
    driver.answerFileDialog(file);
    driver.press("Ctrl+O");
    const bool refused = driver.waitFor([&] { return driver.bench().refused() != nullptr; });
    QTest::qWait(100);
    return refused;
}

/// Takes the size that is proposed for a mesh; whether the part opens then.
bool opensAsAsked(WindowDriver& driver) {
    const bool asked = driver.waitFor([&] {
        const auto* open = driver.window().findChild<QWidget*>(QStringLiteral("import-open"));
        return open && open->isVisible();
    });
    if (asked)
        driver.click("import-open");
    return asked && driver.waitFor([&] { return driver.bench().project().part != nullptr; });
}

Banner& banner(WindowDriver& driver) {
    return *driver.window().findChild<Banner*>();
}

int redPixels(PartView& view) {
    const QImage picture = view.grabFramebuffer();
    int red = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QColor c = picture.pixelColor(x, y);
            red += c.red() > 120 && c.green() < c.red() / 2 && c.blue() < c.red() / 2;
        }
    return red;
}

} // namespace

TEST(Refusal, AMeshWithHolesIsShownWithThemAndWhatWasThereComesBack) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.window().actions()[QStringLiteral("turn-x")]->trigger();
    driver.selectRow("plane");
    ASSERT_TRUE(driver.waitIdle());
    PartView& view = driver.window().view();
    ASSERT_TRUE(driver.waitFor([&] { return !view.drawing(); }));
    const auto hash = test::hashOf(driver.bench().project());
    const scene::SharedDrawnMesh surface = view.scene().surface();
    const Eigen::Vector3d eye = view.camera().position();

    const test::ScratchFolder folder;
    driver.answerQuestion("leave-discard");
    ASSERT_TRUE(openRefused(driver, written(folder, "holed.ply", withTwoHoles())));
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    EXPECT_TRUE(banner(driver).isVisible());
    EXPECT_TRUE(banner(driver).headline().contains(QStringLiteral("holed.ply")));
    EXPECT_EQ(view.scene().surface(), driver.bench().refused()->drawn);
    EXPECT_EQ(view.scene().faults().edgeCount(), 4 + 3);
    EXPECT_FALSE(driver.window().actions()[QStringLiteral("undo")]->isEnabled());
    EXPECT_FALSE(driver.window().actions()[QStringLiteral("run")]->isEnabled());
    EXPECT_EQ(test::hashOf(driver.bench().project()), hash);
    driver.shot("14-error");

    // From place to place: by the banner's button, then by key.
    auto& tree = *driver.window().findChild<ProjectTree*>();
    driver.click("banner-action-2");
    EXPECT_EQ(tree.selectedId(), QStringLiteral("fault-0"));
    ASSERT_TRUE(driver.waitFor([&] { return view.camera().focus.x() < 31; }));
    driver.shot("14-error-place");
    driver.press("F3");
    EXPECT_EQ(tree.selectedId(), QStringLiteral("fault-1"));
    ASSERT_TRUE(driver.waitFor([&] { return view.camera().focus.x() > 40; }));
    driver.press("F3");
    EXPECT_EQ(tree.selectedId(), QStringLiteral("fault-0"));

    driver.press("Esc");
    EXPECT_EQ(driver.bench().refused(), nullptr);
    EXPECT_FALSE(banner(driver).isVisible());
    ASSERT_TRUE(driver.waitFor([&] { return view.scene().surface() == surface; }));
    EXPECT_EQ(view.scene().faults().edgeCount(), 0);
    EXPECT_EQ(tree.selectedId(), QStringLiteral("plane"));
    EXPECT_TRUE(view.camera().position().isApprox(eye, 1e-9));
    EXPECT_EQ(test::hashOf(driver.bench().project()), hash);
    driver.press("Ctrl+Z");
    EXPECT_NE(test::hashOf(driver.bench().project()), hash);
}

TEST(Refusal, FacesThatCrossAreRed) {
    WindowDriver driver;
    const test::ScratchFolder folder;
    ASSERT_TRUE(openRefused(driver, written(folder, "crossing.ply", crossing())));
    PartView& view = driver.window().view();
    EXPECT_TRUE(driver.waitFor([&] { return redPixels(view) > 500; }));
    driver.shot("14-error-crossing");
    driver.window().actions()[QStringLiteral("copy-diagnosis")]->trigger();
    EXPECT_TRUE(QApplication::clipboard()->text().contains(QStringLiteral("crosses itself")));
    driver.click("banner-close");
    EXPECT_EQ(driver.bench().refused(), nullptr);
    EXPECT_FALSE(view.isVisible()) << "the start page is back";
    ASSERT_TRUE(driver.openSample("praline"));
    ASSERT_TRUE(driver.waitFor([&] { return view.scene().surface() != nullptr; }));
    driver.press("L"); // the undercuts' red would be taken for it
    ASSERT_TRUE(driver.waitFor([&] { return !view.drawing(); }));
    EXPECT_EQ(redPixels(view), 0);
}

TEST(Refusal, ReadAgainTakesTheFileOnceItIsMended) {
    WindowDriver driver;
    const test::ScratchFolder folder;
    const QString file = written(folder, "part.ply", crossing());
    ASSERT_TRUE(openRefused(driver, file));
    written(folder, "part.ply", withTwoHoles());
    driver.press("F5");
    ASSERT_TRUE(driver.waitFor([&] { return banner(driver).headline().contains(QStringLiteral("hole")); }));
    written(folder, "part.ply", test::sphere({0, 0, 0}, 10, 3));
    driver.press("F5");
    ASSERT_TRUE(opensAsAsked(driver));
    EXPECT_EQ(driver.bench().refused(), nullptr);
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_FALSE(banner(driver).isVisible());
}

TEST(Refusal, RepairOpensAMendedPartAndTellsWhatWasDone) {
    WindowDriver driver;
    const test::ScratchFolder folder;
    ASSERT_TRUE(openRefused(driver, written(folder, "holed.ply", withTwoHoles())));
    driver.press("Ctrl+R");
    ASSERT_TRUE(opensAsAsked(driver));
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_EQ(driver.bench().refused(), nullptr);
    EXPECT_FALSE(banner(driver).isVisible());
    EXPECT_EQ(driver.bench().project().name, "holed");
    const IndexedMesh whole =
        test::together(test::box({0, 0, 0}, {30, 20, 20}), test::sphere({50, 10, 10}, 10, 3));
    EXPECT_NEAR(volume(*driver.bench().project().part), volume(whole), 1e-3 * volume(whole));
    QStringList told;
    for (int row = 0; row < driver.bench().messages()->rowCount(); ++row)
        told << driver.bench().messages()->at(row).text;
    EXPECT_TRUE(told.join(u' ').contains(QStringLiteral("2 holes were filled")))
        << told.join(u'\n').toStdString();
    driver.shot("14-error-repaired");
}

TEST(Refusal, WhatCannotBeRepairedStaysInViewWithTheReason) {
    WindowDriver driver;
    const test::ScratchFolder folder;
    IndexedMesh sheet = test::box({0, 0, 0}, {30, 20, 20});
    sheet.F = sheet.F.topRows(1).eval();
    ASSERT_TRUE(openRefused(driver, written(folder, "sheet.ply", sheet)));
    driver.press("Ctrl+R");
    ASSERT_TRUE(driver.waitFor(
        [&] { return banner(driver).headline().contains(QStringLiteral("cannot be repaired")); }));
    EXPECT_NE(driver.bench().refused(), nullptr);
    EXPECT_EQ(driver.bench().project().part, nullptr);
    driver.shot("14-error-beyond-repair");
}

TEST(Refusal, AFileThatIsNoMeshIsToldWithoutADialog) {
    WindowDriver driver;
    const test::ScratchFolder folder;
    std::ofstream(folder.path() / "letter.stl") << "Dear mold maker,\n";
    driver.answerFileDialog(QString::fromStdString((folder.path() / "letter.stl").string()));
    driver.press("Ctrl+O");
    ASSERT_TRUE(driver.waitFor([&] { return banner(driver).isVisible(); }));
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    EXPECT_TRUE(banner(driver).headline().contains(QStringLiteral("letter.stl")));
    EXPECT_EQ(driver.bench().refused(), nullptr);
    driver.shot("14-error-no-mesh");
    ASSERT_TRUE(driver.openSample("praline"));
    EXPECT_FALSE(banner(driver).isVisible());
}

TEST(Refusal, EveryDamagedModelThatCanBeShownHasItsPlaces) {
    const char* models = std::getenv("MOLDWRIGHT_BAD_MODELS");
    if (!models)
        GTEST_SKIP() << "MOLDWRIGHT_BAD_MODELS is not set";
    int shown = 0;
    for (const auto& entry : std::filesystem::directory_iterator(models)) {
        const Result<ReadMesh> read = readMesh(entry.path());
        if (!read)
            continue;
        Examination part = examine(read->mesh, entry.path().filename().string());
        if (part.faults.empty())
            continue;
        const bool somewhere = !part.faults.front().places.empty();
        const auto refused = refusedMesh(QString::fromStdString(entry.path().string()), std::move(part));
        if (!refused)
            continue;
        ++shown;
        // What encloses nothing may be at fault as a whole, and in no place.
        EXPECT_TRUE(!somewhere || !refused->places.empty()) << entry.path();
        EXPECT_EQ(refused->places.empty(), refused->edges.empty() && refused->paintedFaces.empty())
            << entry.path();
        for (const FaultPlace& place : refused->places)
            EXPECT_TRUE(refused->drawn->box.contains(place.box)) << entry.path();
    }
    EXPECT_GT(shown, 20);
}

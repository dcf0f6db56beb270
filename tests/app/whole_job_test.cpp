// SPDX-License-Identifier: AGPL-3.0-or-later
// The whole job through the real window, by the events a user makes.
#include "app/window_driver.h"

#include "castability/certificate.h"
#include "exchange/mesh_file.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "panels/banner.h"
#include "panels/message_list.h"
#include "panels/property_panel.h"
#include "panels/step_button.h"
#include "panels/workflow_bar.h"
#include "support/folders.h"
#include "support/shapes.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/main_window.h"

#include <QComboBox>
#include <QFile>
#include <QSlider>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>

using namespace moldwright;
using test::WindowDriver;

namespace {

QString verdict(WindowDriver& driver) {
    return driver.window().findChild<VerdictButton*>()->sentence();
}

/// How much of a picture is in the accent's hue.
int bluePixels(const QImage& picture) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            count += qBlue(picture.pixel(x, y)) > qRed(picture.pixel(x, y)) + 60 ? 1 : 0;
    return count;
}

void choosePlane(WindowDriver& driver) {
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_EQ(driver.bench().document().history().steps().size(), 1U);
    driver.shot("03-best-plane");
}

void bendUntilProved(WindowDriver& driver) {
    const SharedMesh part = driver.bench().project().part;
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().frame().has_value(); }, 180000));
    EXPECT_NE(driver.bench().shownMesh(), part) << "the shape is to be seen bending";
    driver.shot("04-running");
    ASSERT_TRUE(driver.waitIdle(300000));
    ASSERT_TRUE(driver.bench().project().cast);
    driver.shot("05-deformed");
    EXPECT_EQ(verdict(driver), QStringLiteral("Castable"));
}

void buildTheMold(WindowDriver& driver) {
    driver.press("Ctrl+M");
    ASSERT_TRUE(driver.waitIdle());
    ASSERT_TRUE(driver.bench().mold());
    QTest::qWait(900); // the halves move apart
    driver.shot("06-mold");
    auto* slider = driver.window().findChild<QSlider*>(QStringLiteral("opening"));
    const scene::Scene& scene = driver.window().view().scene();
    for (const Qt::Key key : {Qt::Key_Home, Qt::Key_Right, Qt::Key_PageUp, Qt::Key_PageUp, Qt::Key_End}) {
        QTest::keyClick(slider, key);
        EXPECT_EQ(scene.facesMet(), 0) << "proved halves meet nothing at " << slider->value();
    }
    EXPECT_EQ(verdict(driver), QStringLiteral("Castable and opens"));
}

/// What an STL or PLY file on the disk holds, when it is a closed, sound mesh.
std::optional<IndexedMesh> soundMesh(const std::filesystem::path& file) {
    const Result<ReadMesh> read = readMesh(file);
    const auto sound = read ? prepare(read->mesh, file.filename().string()) : std::unexpected(read.error());
    return sound ? std::optional(sound->mesh) : std::nullopt;
}

void exportEverything(WindowDriver& driver) {
    const test::ScratchFolder folder;
    driver.answerFileDialog(QString::fromStdString(folder.path().string()));
    driver.press("Ctrl+Shift+E");
    ASSERT_TRUE(driver.waitIdle());
    for (const char* half : {"mold-half-1.stl", "mold-half-2.stl"})
        EXPECT_TRUE(soundMesh(folder.path() / half)) << half;

    driver.answerFileDialog(QString::fromStdString((folder.path() / "cast.ply").string()));
    driver.press("Ctrl+E");
    ASSERT_TRUE(driver.waitIdle());
    const std::optional<IndexedMesh> cast = soundMesh(folder.path() / "cast.ply");
    ASSERT_TRUE(cast);
    const CastResult& result = *driver.bench().project().cast;
    EXPECT_TRUE(certify(*cast, result.labels, result.state, 1).holds()) << "on the file as written";

    driver.answerFileDialog(QString::fromStdString((folder.path() / "report.pdf").string()));
    driver.press("Ctrl+P");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "report.pdf"))
        << driver.bench().messages()->at(0).text.toStdString();
}

void wholeJob(WindowDriver& driver) {
    driver.shot("02-opened");
    EXPECT_EQ(verdict(driver), QStringLiteral("Not castable yet"));
    ASSERT_NO_FATAL_FAILURE(choosePlane(driver));
    ASSERT_NO_FATAL_FAILURE(bendUntilProved(driver));
    ASSERT_NO_FATAL_FAILURE(buildTheMold(driver));
    ASSERT_NO_FATAL_FAILURE(exportEverything(driver));
}

} // namespace

TEST(WholeJob, SampleToMold) {
    WindowDriver driver;
    driver.shot("01-start");
    EXPECT_EQ(verdict(driver), QStringLiteral("No part open"));
    ASSERT_TRUE(driver.openSample("rabbit"));
    wholeJob(driver);
}

TEST(WholeJob, AFileWithoutASizeOfItsOwnToMold) {
    const auto models = test::models();
    if (!models)
        GTEST_SKIP() << "MOLDWRIGHT_MODELS is not set";
    WindowDriver driver;
    ASSERT_TRUE(driver.openMesh(QString::fromStdString((*models / "spot.obj").string()), 80));
    EXPECT_NEAR(boundingBox(*driver.bench().project().part).sizes().maxCoeff(), 80, 1e-9);
    wholeJob(driver);
}

TEST(WholeJob, ARunIsHeldAndFinishedFromWhereItIs) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("bent_beam"));
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().progress().size() >= 3; }, 180000));
    driver.press("Space");
    ASSERT_TRUE(driver.bench().resting());
    QTest::qWait(300); // a step under way ends
    const std::size_t steps = driver.bench().progress().size();
    const SharedMesh shape = driver.bench().shownMesh();
    QTest::qWait(400);
    EXPECT_EQ(driver.bench().progress().size(), steps);
    EXPECT_EQ(driver.bench().shownMesh(), shape);
    driver.shot("20-paused");

    driver.press("Space");
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().progress().size() > steps; }));
    driver.press("Space");
    driver.press("Ctrl+Shift+Return");
    ASSERT_TRUE(driver.waitIdle());
    ASSERT_TRUE(driver.bench().project().cast);
    EXPECT_EQ(verdict(driver), QStringLiteral("Castable"));
    EXPECT_LT(driver.bench().progress().size(), 120U) << "a whole run takes 160 steps and more";
}

TEST(WholeJob, AStoppedRunKeepsWhatItReachedInOneUndoStepAndCanGoOn) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("bent_beam"));
    const Project before = driver.bench().document().committed();
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().frame().has_value(); }, 180000));
    driver.press("Space");
    driver.press("Ctrl+.");
    ASSERT_TRUE(driver.waitIdle());
    const Project stopped = driver.bench().document().committed();
    ASSERT_TRUE(stopped.cast);
    EXPECT_EQ(driver.bench().shownMesh(), stopped.cast->mesh);
    EXPECT_GT(stopped.cast->change.meanDistance, 0) << "it was bent";
    EXPECT_EQ(verdict(driver), QStringLiteral("Not castable yet"));
    EXPECT_FALSE(driver.window().actions()[QStringLiteral("build-mold")]->isEnabled());
    EXPECT_TRUE(driver.window().findChild<Banner*>()->isVisible());
    driver.shot("21-stopped");

    driver.press("Ctrl+Z");
    EXPECT_TRUE(driver.bench().document().committed() == before);
    driver.press("Ctrl+Shift+Z");
    EXPECT_TRUE(driver.bench().document().committed() == stopped);

    driver.click("banner-action");
    ASSERT_TRUE(driver.bench().running());
    ASSERT_TRUE(driver.waitIdle(300000));
    EXPECT_EQ(verdict(driver), QStringLiteral("Castable"));
    EXPECT_EQ(driver.bench().project().state->plane, stopped.state->plane) << "it need not search again";
}

TEST(WholeJob, ARunStoppedBeforeItHasAShapeLeavesThePartAsItWas) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("goat_head"));
    const Project before = driver.bench().document().committed();
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.bench().running());
    driver.press("Ctrl+.");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_TRUE(driver.bench().document().committed() == before);
}

TEST(WholeJob, AnObstructionIsMarkedListedShownAndFilled) {
    WindowDriver driver;
    const test::ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "ring.ply";
    const IndexedMesh ring = test::rotated(test::torus(30, 10, 48, 20), Eigen::Vector3d::UnitX(), 1.5);
    ASSERT_TRUE(writeMesh(file, ring, MeshFormat::Ply));
    ASSERT_TRUE(driver.openMesh(QString::fromStdString(file.string()), 80));
    // Upright, and parted across its hole: each half spans a gap.
    driver.selectRow("plane");
    driver.type("field-offset", "1");
    driver.selectRow("deform");
    auto* fill = driver.window().findChild<QComboBox*>(QStringLiteral("choice-fill"));
    ASSERT_TRUE(fill);
    fill->setFocus();
    QTest::keyClick(fill, Qt::Key_Up);
    ASSERT_EQ(driver.bench().project().design.fill, FillChoice::None);
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(180000));

    ASSERT_FALSE(driver.bench().obstructions().empty());
    const Obstruction& found = driver.bench().obstructions().front();
    EXPECT_EQ(found.kind, Obstruction::Kind::Handle);
    EXPECT_EQ(verdict(driver), QStringLiteral("Cannot be cast yet"));
    EXPECT_TRUE(driver.window().findChild<Banner*>()->isVisible());
    auto* panel = driver.window().findChild<PropertyPanel*>();
    EXPECT_EQ(panel->pageId(), QStringLiteral("obstruction-0"));
    driver.shot("22-obstruction");

    // A click on its mark comes back to it.
    driver.selectRow("part");
    EXPECT_EQ(panel->pageId(), QStringLiteral("part"));
    PartView& view = driver.window().view();
    QTest::mouseClick(&view, Qt::LeftButton, {}, view.pixelOf(found.place));
    QTest::qWait(300);
    EXPECT_EQ(panel->pageId(), QStringLiteral("obstruction-0"));

    // Its message points at its faces for a moment.
    auto* messages = driver.window().findChild<MessageList*>();
    messages->setFocus();
    QTest::keyClick(messages, Qt::Key_Home);
    QTest::keyClick(messages, Qt::Key_Return);
    QTest::qWait(700); // the camera eases
    const int pointedAt = bluePixels(view.picture());
    driver.shot("22-pointed-at");
    QTest::qWait(1500);
    EXPECT_GT(pointedAt, bluePixels(view.picture()) + 300);

    // The plane that the run suggests is taken and given back in one step.
    const auto suggested = driver.bench().suggestedPlane();
    ASSERT_TRUE(suggested);
    const auto plane = driver.bench().project().state;
    driver.click("button-suggested-plane");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_EQ(driver.bench().project().state, suggested);
    EXPECT_FALSE(driver.window().actions()[QStringLiteral("suggested-plane")]->isEnabled());
    driver.press("Ctrl+Z");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_EQ(driver.bench().project().state, plane);

    driver.window().actions()[QStringLiteral("fill-and-run")]->trigger();
    ASSERT_TRUE(driver.waitIdle(300000));
    ASSERT_TRUE(driver.bench().project().cast);
    EXPECT_EQ(verdict(driver), QStringLiteral("Castable"));
    EXPECT_GT(driver.bench().project().cast->change.filledVolumeFraction, 0.05);
    EXPECT_TRUE(driver.bench().obstructions().empty());
    driver.selectRow("cast");
    driver.shot("23-filled");
}

TEST(WholeJob, UndercutsAreFilledOneByOne) {
    WindowDriver driver;
    const test::ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "ring.ply";
    const IndexedMesh ring = test::rotated(test::torus(30, 10, 48, 20), Eigen::Vector3d::UnitX(), 1.5);
    ASSERT_TRUE(writeMesh(file, ring, MeshFormat::Ply));
    ASSERT_TRUE(driver.openMesh(QString::fromStdString(file.string()), 80));
    driver.selectRow("plane");
    driver.type("field-offset", "1");
    auto* panel = driver.window().findChild<PropertyPanel*>();

    // All undercuts of this plane. The ring's hole, above and below, is one that no bending frees.
    driver.press("Ctrl+Shift+U");
    ASSERT_TRUE(driver.waitIdle(60000));
    EXPECT_EQ(panel->pageId(), QStringLiteral("undercuts"));
    const auto& undercuts = driver.bench().undercuts();
    const auto needed = std::ranges::find_if(undercuts, [](const auto& undercut) { return undercut.needed; });
    ASSERT_NE(needed, undercuts.end());
    const auto hole = static_cast<int>(needed - undercuts.begin());
    driver.shot("24-undercuts");

    // It is chosen to be filled, in one step that can be undone.
    driver.selectRow(("undercut-" + std::to_string(hole)).c_str());
    auto* treatment = driver.window().findChild<QComboBox*>(QStringLiteral("choice-treatment-%1").arg(hole));
    ASSERT_TRUE(treatment);
    treatment->setFocus();
    QTest::keyClick(treatment, Qt::Key_End);
    EXPECT_EQ(driver.bench().treatmentOf(hole), UndercutChoice::Treatment::Fill);
    driver.shot("25-undercut");
    driver.press("Ctrl+Z");
    EXPECT_EQ(driver.bench().treatmentOf(hole), std::nullopt);

    // Where nothing is filled by rule it stands in the way, and is accepted from the obstruction's page.
    driver.selectRow("deform");
    auto* fill = driver.window().findChild<QComboBox*>(QStringLiteral("choice-fill"));
    ASSERT_TRUE(fill);
    fill->setFocus();
    QTest::keyClick(fill, Qt::Key_Up);
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(180000));
    ASSERT_FALSE(driver.bench().obstructions().empty());
    EXPECT_FALSE(driver.bench().willBeFilled(0));
    driver.click("button-fill-here");
    EXPECT_TRUE(driver.bench().willBeFilled(0));
    driver.shot("26-to-be-filled");
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(180000));
    ASSERT_TRUE(driver.bench().project().cast);
    EXPECT_EQ(verdict(driver), QStringLiteral("Castable"));
    EXPECT_GT(driver.bench().project().cast->change.filledVolumeFraction, 0.05);
}

TEST(WholeJob, DirectionsKeepToThePressAxis) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.selectRow("plane");
    auto* axis = driver.window().findChild<QComboBox*>(QStringLiteral("choice-axis"));
    ASSERT_TRUE(axis);
    axis->setFocus();
    QTest::keyClick(axis, Qt::Key_Z);
    EXPECT_EQ(driver.bench().project().design.limits.axis, Eigen::Vector3d(0, 0, 1));
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle(60000));
    EXPECT_EQ(std::abs(driver.bench().project().state->directions.d1.z()), 1);
    EXPECT_EQ(std::abs(driver.bench().project().state->directions.d2.z()), 1);
}

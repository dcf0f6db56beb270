// SPDX-License-Identifier: AGPL-3.0-or-later
// Planes offered and snapped, pins set and suggested, through the real window.
#include "app/window_driver.h"

#include "castability/crease.h"
#include "castability/plane_snaps.h"
#include "mesh/closest_point.h"
#include "mesh/measures.h"
#include "panels/picture_list.h"
#include "panels/project_tree.h"
#include "panels/property_panel.h"
#include "panels/workflow_bar.h"
#include "pins/cgal/inside_test.h"
#include "scene/direction_handle.h"
#include "support/folders.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/main_window.h"
#include "window/pin_offers.h"
#include "window/presentation.h"
#include "window/row_commands.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QMouseEvent>
#include <QSlider>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace moldwright;
using namespace Qt::StringLiterals;
using test::WindowDriver;

namespace {

PictureList* offeredList(WindowDriver& driver) {
    return driver.window().findChild<PictureList*>(QStringLiteral("pictures-offered"));
}

const std::vector<NamedPin>& pins(WindowDriver& driver) {
    return driver.bench().project().pins;
}

void clickAt(WindowDriver& driver, const Eigen::Vector3d& place, Qt::KeyboardModifiers keys = {}) {
    PartView& view = driver.window().view();
    QTest::mouseClick(&view, Qt::LeftButton, keys, view.pixelOf(place));
    QTest::qWait(60);
}

/// A point of the part that faces the camera, away from its silhouette and from the plane's grips.
Eigen::Vector3d seenPlace(WindowDriver& driver, const Eigen::Vector3d& like) {
    const IndexedMesh& part = *driver.bench().project().part;
    const Eigen::Vector3d eye = driver.window().view().camera().backwards();
    int best = 0;
    double most = -1e9;
    for (int f = 0; f < part.faceCount(); ++f) {
        const Eigen::Vector3d normal = doubleAreaVector(part, f).normalized();
        const Eigen::Vector3d middle = (part.corner(f, 0) + part.corner(f, 1) + part.corner(f, 2)) / 3;
        // Nearest to the eye of those that look at it: nothing lies before it.
        const double worth = normal.dot(eye) < 0.8 ? -1e9 : middle.dot(eye) + 0.2 * middle.dot(like);
        if (worth > most) {
            most = worth;
            best = f;
        }
    }
    return (part.corner(best, 0) + part.corner(best, 1) + part.corner(best, 2)) / 3;
}

} // namespace

TEST(OfferedPlanes, AreDistinctPicturedTriedByClickAndKeysAndOneUndoStep) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    const Project before = driver.bench().document().committed();
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    const auto& offered = driver.bench().offeredPlanes();
    ASSERT_GE(offered.size(), 3U);
    for (std::size_t i = 0; i < offered.size(); ++i) {
        EXPECT_TRUE(std::ranges::any_of(offered[i].picture.rgba, [](auto byte) { return byte == 255; }));
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_NE(offered[i].plane.state, offered[k].plane.state);
            EXPECT_NE(offered[i].picture.rgba, offered[k].picture.rgba);
        }
    }
    PictureList* list = offeredList(driver);
    ASSERT_TRUE(list);
    EXPECT_TRUE(list->isVisible());
    EXPECT_EQ(list->count(), static_cast<int>(offered.size()));
    EXPECT_EQ(list->currentRow(), 0);
    EXPECT_EQ(driver.bench().project().state, offered[0].plane.state);
    driver.shot("30-offered-planes");

    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(1)).center());
    QTest::qWait(50);
    EXPECT_EQ(driver.bench().project().state, offered[1].plane.state);
    list = offeredList(driver);
    list->setFocus();
    driver.press("Down");
    EXPECT_EQ(driver.bench().offeredPlane(), 3) << "the one below in two columns";
    driver.press("Ctrl+Shift+B");
    EXPECT_EQ(driver.bench().offeredPlane(), 4 % static_cast<int>(offered.size()));
    EXPECT_EQ(driver.bench().document().history().steps().size(), 1U);
    driver.press("Ctrl+Z");
    EXPECT_TRUE(driver.bench().document().committed() == before);
    EXPECT_EQ(driver.bench().offeredPlane(), -1);
    ASSERT_TRUE(driver.waitIdle());
}

TEST(OfferedPlanes, ASearchThatIsCancelledLeavesAllAsItWas) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("goat_head"));
    const Project before = driver.bench().document().committed();
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.bench().background().busy());
    driver.bench().stop();
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_TRUE(driver.bench().document().committed() == before);
    EXPECT_TRUE(driver.bench().offeredPlanes().empty());
}

TEST(PlaneSnapping, ToAnAxisByItsKeyInOneStep) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    driver.press("Shift+X");
    const PartingPlane& plane = driver.bench().project().state->plane;
    EXPECT_NEAR(std::abs(plane.normal.x()), 1, 1e-12);
    const Eigen::Vector3d middle = boundingBox(*driver.bench().project().part).center();
    EXPECT_NEAR(plane.distance(middle), 0, 1e-9);
    EXPECT_GT(driver.bench().project().state->directions.d1.dot(plane.normal), 0.99);
    EXPECT_EQ(driver.bench().document().history().steps().size(), 1U);
    driver.press("Ctrl+Z");
    ASSERT_TRUE(driver.waitIdle());
}

TEST(PlaneSnapping, ToThreeClickedPointsAndToAClickedFace) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    const std::vector<Eigen::Vector3d> places = {
        seenPlace(driver, {0, 0, 30}), seenPlace(driver, {0, 0, -30}), seenPlace(driver, {30, -5, 0})};
    driver.press("T");
    EXPECT_EQ(driver.window().view().picking(), PartView::Picking::Place);
    clickAt(driver, places[0]);
    clickAt(driver, places[1]);
    driver.shot("31-three-points");
    clickAt(driver, places[2]);
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_EQ(driver.window().view().picking(), PartView::Picking::Nothing);
    const double size = diagonal(*driver.bench().project().part);
    for (const Eigen::Vector3d& place : places) // to what a pixel covers
        EXPECT_NEAR(driver.bench().project().state->plane.distance(place), 0, 0.02 * size);
    EXPECT_EQ(driver.bench().document().history().steps().size(), 1U);

    driver.press("Ctrl+Z");
    ASSERT_TRUE(driver.waitIdle());
    driver.press("Shift+T");
    driver.press("Esc");
    EXPECT_EQ(driver.window().view().picking(), PartView::Picking::Nothing);
    driver.press("Shift+T");
    clickAt(driver, places[0]);
    ASSERT_TRUE(driver.waitIdle());
    const IndexedMesh& part = *driver.bench().project().part;
    const MoldState state = *driver.bench().project().state;
    double nearest = 1;
    for (int f = 0; f < part.faceCount(); ++f)
        if (const auto plane = planeOfFace(part, f, state.plane))
            nearest = std::min(nearest, (plane->normal - state.plane.normal).norm() +
                                            std::abs(plane->offset - state.plane.offset));
    EXPECT_LT(nearest, 1e-9);
}

TEST(Directions, ThatAreNotParallelCreaseThePartingLine) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    EXPECT_EQ(driver.window().view().scene().sharpestCrease().degrees, 0);
    driver.selectRow("direction-1");
    driver.type("field-lean1", "20");
    ASSERT_TRUE(driver.waitIdle());
    const scene::SharpestCrease& crease = driver.window().view().scene().sharpestCrease();
    EXPECT_NEAR(crease.degrees, sharpestCreaseDegrees(*driver.bench().project().state), 0.5);
    EXPECT_NEAR(crease.degrees, 20, 0.5);
    driver.shot("32-cone-and-crease");
}

TEST(Pins, AreSetOnTheSurfaceAndInsideSelectedMovedHiddenAndRemoved) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    const SharedMesh part = driver.bench().project().part;
    const Eigen::Vector3d place = seenPlace(driver, Eigen::Vector3d::Zero());
    driver.press("P");
    clickAt(driver, place);
    ASSERT_EQ(pins(driver).size(), 1U);
    const ClosestPoint surface(*part);
    EXPECT_NEAR(surface.distance(pins(driver)[0].point), 0, 1e-6 * diagonal(*part));
    EXPECT_LT((pins(driver)[0].point - place).norm(), 0.02 * diagonal(*part));

    clickAt(driver, seenPlace(driver, {0, 0, -30}), Qt::ShiftModifier);
    ASSERT_EQ(pins(driver).size(), 2U);
    EXPECT_TRUE(InsideTest(*part).inside(pins(driver)[1].point));
    EXPECT_GT(surface.distance(pins(driver)[1].point), 0.005 * diagonal(*part));
    driver.shot("33-pins");
    driver.press("Esc");
    EXPECT_EQ(driver.bench().document().history().steps().size(), 2U);

    // A click on a pin selects it; its place is typed; Del removes it; each is a step.
    driver.selectRow("part");
    clickAt(driver, pins(driver)[1].point);
    auto* panel = driver.window().findChild<PropertyPanel*>();
    EXPECT_EQ(panel->pageId(), QStringLiteral("pin-1"));
    const double x = pins(driver)[1].point.x();
    driver.type("field-pin-place-x", QString::number(x + 1, 'f', 2).toUtf8().constData());
    EXPECT_NEAR(pins(driver)[1].point.x(), x + 1, 0.01);
    const Project withBoth = driver.bench().document().committed();
    driver.window().view().setFocus();
    driver.press("Del");
    EXPECT_EQ(pins(driver).size(), 1U);
    EXPECT_EQ(panel->pageId(), QStringLiteral("pins"));
    EXPECT_EQ(driver.bench().document().history().steps().size(), 4U);
    driver.press("Ctrl+Z");
    EXPECT_TRUE(driver.bench().document().committed() == withBoth);

    // The eye of their row hides them: nothing is left to be clicked.
    EXPECT_EQ(driver.window().view().scene().pins().pins().pins.size(), 2U);
    auto* tree = driver.window().findChild<ProjectTree*>();
    driver.selectRow("pins");
    tree->setFocus();
    driver.press("Space");
    QTest::qWait(50);
    EXPECT_TRUE(driver.window().view().scene().pins().pins().pins.empty());
    driver.press("Space");

    driver.window().actions()[QStringLiteral("clear-pins")]->trigger();
    EXPECT_TRUE(pins(driver).empty());
}

TEST(Pins, AreDraggedOverTheSurfaceAndInsideEachInOneStepAndHiddenOneByOne) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    const SharedMesh part = driver.bench().project().part;
    const Eigen::Vector3d place = seenPlace(driver, Eigen::Vector3d::Zero());
    driver.press("P");
    clickAt(driver, place);
    driver.press("Esc");
    ASSERT_EQ(pins(driver).size(), 1U);
    const Pin before = pins(driver)[0];
    PartView* view = &driver.window().view();
    const auto drag = [&](const QPoint& way, bool cancel) {
        const QPoint from = view->pixelOf(pins(driver)[0].point);
        QTest::mousePress(view, Qt::LeftButton, {}, from);
        for (int i = 1; i <= 4; ++i) {
            const QPoint at = from + way * i / 4;
            QMouseEvent event(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(view, &event);
        }
        if (cancel)
            driver.press("Esc");
        QTest::mouseRelease(view, Qt::LeftButton, {}, from + way);
        QTest::qWait(60);
    };
    drag({0, 24}, false);
    EXPECT_NE(pins(driver)[0], before);
    const ClosestPoint surface(*part);
    EXPECT_NEAR(surface.distance(pins(driver)[0].point), 0, 1e-6 * diagonal(*part))
        << "it stays on the surface";
    EXPECT_EQ(driver.bench().document().history().steps().size(), 2U);
    EXPECT_EQ(driver.window().findChild<PropertyPanel*>()->pageId(), QStringLiteral("pin-0"));
    const Pin dragged = pins(driver)[0];
    drag({0, -24}, true);
    EXPECT_EQ(pins(driver)[0], dragged) << "Esc gives the drag up";
    driver.press("Ctrl+Z");
    EXPECT_EQ(pins(driver)[0], before);

    // One inside stays inside.
    driver.press("Del");
    driver.press("P");
    clickAt(driver, place, Qt::ShiftModifier);
    driver.press("Esc");
    ASSERT_EQ(pins(driver).size(), 1U);
    drag({0, 16}, false);
    EXPECT_TRUE(InsideTest(*part).inside(pins(driver)[0].point));
    EXPECT_GT(surface.distance(pins(driver)[0].point), 1e-3 * diagonal(*part));

    driver.selectRow("pin-0");
    driver.window().findChild<ProjectTree*>()->setFocus();
    driver.press("Space");
    QTest::qWait(50);
    EXPECT_TRUE(view->scene().pins().pins().pins.empty()) << "its own eye hides it";
}

TEST(Pins, AreNamedInTheTreeHiddenByAKeyAndEveryRowHasItsMenu) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.bench().addPin(driver.bench().figures(driver.bench().project().part).box.center());
    driver.bench().addPin(driver.bench().project().part->point(0));
    QTest::qWait(50);
    driver.selectRow("pin-1");
    driver.press("F2");
    QWidget* editor = QApplication::focusWidget();
    QTest::keyClicks(editor, u"Left ear"_s);
    QTest::keyClick(editor, Qt::Key_Return);
    QTest::qWait(50);
    EXPECT_EQ(pins(driver)[1].name, "Left ear");
    EXPECT_EQ(driver.bench().pinName(0), u"Pin 1"_s);
    EXPECT_EQ(driver.bench().document().history().steps().back().words, u"Rename"_s);
    driver.selectRow("pin-1");
    driver.press("H");
    QTest::qWait(50);
    EXPECT_EQ(driver.window().view().scene().pins().pins().pins.size(), 1U);
    driver.press("H");
    driver.press("Ctrl+Z");
    EXPECT_EQ(driver.bench().pinName(1), u"Pin 2"_s);

    // What a menu offers is a command, whatever the row.
    auto* model = static_cast<ProjectModel*>(driver.window().findChild<ProjectTree*>()->model());
    std::set<QString> known;
    for (const QAction* command : driver.window().actions().all())
        known.insert(command->objectName());
    for (const char* row :
         {"part", "variants", "plane", "direction-1", "pins", "pin-0", "importance", "deform", "mold"}) {
        EXPECT_TRUE(model->indexOf(QString::fromLatin1(row)).isValid()) << row;
        const QStringList commands = commandsOfRow(QString::fromLatin1(row));
        EXPECT_FALSE(commands.isEmpty()) << row;
        for (const QString& command : commands)
            EXPECT_TRUE(command.isEmpty() || known.contains(command)) << row << ": " << command.toStdString();
    }
}

TEST(Pins, AreSuggestedTakenByClickRankedAtThePlaneAndKeptInFiles) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    driver.press("Ctrl+3");
    driver.press("Ctrl+G");
    ASSERT_TRUE(driver.waitIdle());
    const auto suggested = driver.bench().pinOffers().inView();
    ASSERT_GE(suggested.size(), 20U);
    ASSERT_LE(suggested.size(), 40U);
    driver.shot("34-suggested-pins");

    // Another plane ranks them anew.
    driver.press("Shift+X");
    ASSERT_TRUE(driver.waitFor([&] {
        const auto now = driver.bench().pinOffers().inView();
        return !std::ranges::equal(now, suggested, {}, &SuggestedPin::gain, &SuggestedPin::gain);
    }));
    driver.press("Ctrl+3");

    // The slider shows fewer.
    auto* slider = driver.window().findChild<QSlider*>();
    ASSERT_TRUE(slider);
    slider->setFocus();
    driver.press("Home");
    EXPECT_EQ(driver.bench().pinOffers().count(), 20);
    EXPECT_LE(driver.bench().pinOffers().inView().size(), 20U);

    const auto inView = driver.bench().pinOffers().inView();
    clickAt(driver, inView[0].point);
    ASSERT_EQ(pins(driver).size(), 1U);
    EXPECT_TRUE(std::ranges::count(inView, pins(driver)[0].point, &SuggestedPin::point) == 1);
    EXPECT_EQ(driver.bench().pinOffers().inView().size(), inView.size() - 1);

    const auto tips =
        std::ranges::count(driver.bench().pinOffers().inView(), PinKind::Tip, &SuggestedPin::kind);
    ASSERT_GT(tips, 1);
    driver.press("Ctrl+Shift+G");
    EXPECT_EQ(pins(driver).size(), 1U + static_cast<std::size_t>(tips));
    driver.shot("35-tips-accepted");

    // Into a file, and back from it.
    driver.bench().renamePin(0, u"left \"ear\""_s);
    const std::vector<NamedPin> all = pins(driver);
    const test::ScratchFolder folder;
    const QString file = QString::fromStdString((folder.path() / "pins.json").string());
    driver.answerFileDialog(file);
    driver.window().actions()[QStringLiteral("export-pins")]->trigger();
    ASSERT_TRUE(QFile::exists(file));
    driver.window().actions()[QStringLiteral("clear-pins")]->trigger();
    ASSERT_TRUE(pins(driver).empty());
    driver.answerFileDialog(file);
    driver.window().actions()[QStringLiteral("import-pins")]->trigger();
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_EQ(pins(driver), all);
}

TEST(Pins, AreAcceptedInALasso) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    driver.press("Ctrl+3");
    driver.press("Ctrl+G");
    ASSERT_TRUE(driver.waitIdle());
    const auto suggested = driver.bench().pinOffers().inView();
    ASSERT_GE(suggested.size(), 20U);
    const std::size_t steps = driver.bench().document().history().steps().size();
    PartView& view = driver.window().view();
    // About the middle of all, so that some are inside and some are not.
    QPoint middle;
    for (const SuggestedPin& pin : suggested)
        middle += view.pixelOf(pin.point) / static_cast<int>(suggested.size());
    const QRect box(middle - QPoint(70, 70), middle + QPoint(70, 70));
    std::size_t inside = 0;
    for (const SuggestedPin& pin : suggested)
        inside += box.contains(view.pixelOf(pin.point));
    ASSERT_GT(inside, 0U);
    ASSERT_LT(inside, suggested.size());

    driver.press("Ctrl+Alt+G");
    EXPECT_EQ(view.picking(), PartView::Picking::Lasso);
    QTest::mousePress(&view, Qt::LeftButton, {}, box.topLeft());
    for (const QPoint& corner : {box.topRight(), box.bottomRight(), box.bottomLeft()}) {
        QMouseEvent event(QEvent::MouseMove, corner, view.mapToGlobal(corner), Qt::NoButton, Qt::LeftButton,
                          {});
        QApplication::sendEvent(&view, &event);
    }
    driver.shot("36-suggested-in-a-lasso");
    QTest::mouseRelease(&view, Qt::LeftButton, {}, box.bottomLeft());
    QTest::qWait(50);
    EXPECT_EQ(pins(driver).size(), inside);
    EXPECT_EQ(driver.bench().document().history().steps().size(), steps + 1) << "one step takes them all";
    for (const Pin& pin : pins(driver))
        EXPECT_TRUE(box.contains(view.pixelOf(pin.point)));
    driver.press("Esc");
    driver.press("Ctrl+Z");
    EXPECT_TRUE(pins(driver).empty());
}

TEST(Pins, ARunDrawsThemIntoThePlane) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("rabbit"));
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    driver.press("Ctrl+G");
    ASSERT_TRUE(driver.waitIdle());
    // Two that need not go far: pins that would draw the part through itself are refused.
    const PartingPlane plane = driver.bench().project().state->plane;
    std::vector<SuggestedPin> near = driver.bench().pinOffers().inView();
    std::ranges::sort(near, {}, [&](const SuggestedPin& pin) { return std::abs(plane.distance(pin.point)); });
    ASSERT_GE(near.size(), 2U);
    clickAt(driver, near[0].point);
    clickAt(driver, near[1].point);
    ASSERT_EQ(pins(driver).size(), 2U);
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(300000));
    ASSERT_TRUE(driver.bench().project().cast) << driver.bench().messages()->at(0).text.toStdString();
    EXPECT_EQ(driver.window().findChild<VerdictButton*>()->sentence(), QStringLiteral("Castable"));
    bool told = false;
    for (int row = 0; row < driver.bench().messages()->rowCount(); ++row)
        told = told || driver.bench().messages()->at(row).text.startsWith(QStringLiteral("Pins:"));
    EXPECT_TRUE(told);
    driver.shot("36-pinned-cast");
}

TEST(Visibility, ARemovedRowTakesItsOwnEyeAlone) {
    Visibility visible;
    visible.hidden = {u"pin-1"_s, u"pin-3"_s, u"pin-12"_s, u"region-5"_s};
    forgetRow(visible, u"pin-2"_s);
    EXPECT_EQ(visible.hidden, (std::set<QString>{u"pin-1"_s, u"pin-2"_s, u"pin-11"_s, u"region-5"_s}));
    forgetRow(visible, u"pin-1"_s);
    EXPECT_EQ(visible.hidden, (std::set<QString>{u"pin-1"_s, u"pin-10"_s, u"region-5"_s}));
}

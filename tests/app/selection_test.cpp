// SPDX-License-Identifier: AGPL-3.0-or-later
// Several pins, regions and features chosen at once, in tree and view, and what acts on all of them.
#include "app/window_driver.h"

#include "panels/project_tree.h"
#include "panels/property_panel.h"
#include "panels/quantity_spin_box.h"
#include "project/edits.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/main_window.h"
#include "window/mold_feature_pages.h"
#include "window/mold_placing.h"
#include "window/selection.h"

#include <QMouseEvent>
#include <QTest>

#include <gtest/gtest.h>

using namespace moldwright;
using namespace Qt::StringLiterals;
using test::WindowDriver;

namespace {

const std::vector<NamedPin>& pins(WindowDriver& driver) {
    return driver.bench().project().pins;
}

std::size_t steps(WindowDriver& driver) {
    return driver.bench().document().history().steps().size();
}

PartView& view(WindowDriver& driver) {
    return driver.window().view();
}

QString page(WindowDriver& driver) {
    return driver.window().findChild<PropertyPanel*>()->pageId();
}

QuantitySpinBox& field(WindowDriver& driver, const char* name) {
    return *driver.window().findChild<QuantitySpinBox*>(QString::fromLatin1(name));
}

/// A part with four pins along the screen's diagonal, none before another.
void withFourPins(WindowDriver& driver) {
    ASSERT_TRUE(driver.openSample("praline"));
    const Eigen::AlignedBox3d box = driver.bench().figures(driver.bench().project().part).box;
    std::vector<NamedPin> pins;
    for (int i = 0; i < 4; ++i) {
        const double share = 0.2 + 0.2 * i;
        pins.push_back({{box.min() + share * box.diagonal()}, {}});
    }
    driver.bench().document().edit(u"Pins"_s, withPins(driver.bench().document().committed(), pins));
    driver.selectRow("pins");
    ASSERT_TRUE(driver.waitIdle());
    driver.window().actions()[u"front"_s]->trigger();
    QTest::qWait(400);
}

void clickPin(WindowDriver& driver, int pin, Qt::KeyboardModifiers keys = {}) {
    const QPoint at = view(driver).pixelOf(pins(driver)[static_cast<std::size_t>(pin)].point);
    QTest::mouseClick(&view(driver), Qt::LeftButton, keys, at);
    QTest::qWait(60);
}

void clickRow(WindowDriver& driver, const QString& id, Qt::KeyboardModifiers keys) {
    auto* tree = driver.window().findChild<ProjectTree*>();
    const QModelIndex row = static_cast<ProjectModel*>(tree->model())->indexOf(id);
    ASSERT_TRUE(row.isValid());
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, keys, tree->visualRect(row).center());
    QTest::qWait(60);
}

void drawBox(WindowDriver& driver, const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(&view(driver), Qt::LeftButton, keys, from);
    for (int i = 1; i <= 4; ++i) {
        const QPoint at = from + (to - from) * i / 4;
        QMouseEvent event(QEvent::MouseMove, at, view(driver).mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                          keys);
        QApplication::sendEvent(&view(driver), &event);
    }
    driver.shot("34-box");
    QTest::mouseRelease(&view(driver), Qt::LeftButton, keys, to);
    QTest::qWait(60);
}

std::vector<int> chosenDiscs(WindowDriver& driver) {
    std::vector<int> chosen;
    for (const scene::ShownPin& pin : view(driver).scene().pins().pins().pins)
        if (pin.chosen)
            chosen.push_back(pin.number);
    return chosen;
}

} // namespace

TEST(Choosing, CtrlTogglesShiftAddsAltTakesAwayAndOtherKindsReplace) {
    const auto chosen = [](const char* before, const char* id, Choosing how) {
        return chosenWith(QString::fromLatin1(before), {QString::fromLatin1(id)}, how);
    };
    EXPECT_EQ(chosen("pin-1", "pin-2", Choosing::Only), u"pin-2"_s);
    EXPECT_EQ(chosen("pin-1", "pin-2", Choosing::Toggle), u"pin-1 pin-2"_s);
    EXPECT_EQ(chosen("pin-1 pin-2", "pin-1", Choosing::Toggle), u"pin-2"_s);
    EXPECT_EQ(chosen("pin-1 pin-2", "pin-1", Choosing::Add), u"pin-2 pin-1"_s);
    EXPECT_EQ(chosen("pin-1 pin-2", "pin-2", Choosing::Subtract), u"pin-1"_s);
    EXPECT_EQ(chosen("pin-1", "pin-2", Choosing::Subtract), u"pin-1"_s);
    EXPECT_EQ(chosen("pin-1", "pin-1", Choosing::Toggle), u"pin-1"_s) << "something is always chosen";
    EXPECT_EQ(chosen("pin-1 pin-2", "region-0", Choosing::Add), u"region-0"_s);
    EXPECT_EQ(chosen("plane", "pin-0", Choosing::Add), u"pin-0"_s);
    EXPECT_EQ(chosen("pin-0", "plane", Choosing::Toggle), u"plane"_s);
    EXPECT_EQ(chosenWith(u"pin-3"_s, {u"pin-0"_s, u"pin-1"_s}, Choosing::Add), u"pin-3 pin-0 pin-1"_s);
    EXPECT_EQ(chosenWith(u"pin-3"_s, {}, Choosing::Only), u"pin-3"_s);
}

TEST(Choosing, SeveralPinsInTheViewAreMovedHiddenAndRemovedTogether) {
    WindowDriver driver;
    withFourPins(driver);
    clickPin(driver, 0);
    clickPin(driver, 2, Qt::ControlModifier);
    clickPin(driver, 3, Qt::ShiftModifier);
    EXPECT_EQ(chosenDiscs(driver), (std::vector{0, 2, 3}));
    clickPin(driver, 2, Qt::ControlModifier);
    EXPECT_EQ(chosenDiscs(driver), (std::vector{0, 3}));
    clickPin(driver, 2, Qt::ControlModifier);
    clickPin(driver, 3, Qt::AltModifier);
    EXPECT_EQ(chosenDiscs(driver), (std::vector{0, 2}));
    EXPECT_EQ(page(driver), u"pin-0 pin-2"_s);
    driver.shot("34-pins-chosen");

    // Places differ; what is typed goes to all, in one step.
    EXPECT_TRUE(field(driver, "field-pin-place-x").mixed());
    const std::size_t before = steps(driver);
    driver.type("field-pin-place-x", "4.5");
    EXPECT_EQ(pins(driver)[0].point.x(), 4.5);
    EXPECT_EQ(pins(driver)[2].point.x(), 4.5);
    EXPECT_NE(pins(driver)[1].point.x(), 4.5);
    EXPECT_EQ(steps(driver), before + 1);
    view(driver).setFocus();
    QTest::qWait(60);
    EXPECT_FALSE(field(driver, "field-pin-place-x").mixed());
    EXPECT_EQ(field(driver, "field-pin-place-x").value(), 4.5);
    driver.press("Ctrl+Z");
    QTest::qWait(60);
    EXPECT_TRUE(field(driver, "field-pin-place-x").mixed());

    driver.press("H");
    EXPECT_EQ(view(driver).scene().pins().pins().pins.size(), 2U);
    driver.press("H");
    EXPECT_EQ(view(driver).scene().pins().pins().pins.size(), 4U);

    // F brings both into sight, not one.
    const auto pixel = [&](std::size_t pin) { return view(driver).pixelOf(pins(driver)[pin].point); };
    const int apart = (pixel(0) - pixel(2)).manhattanLength();
    driver.press("F");
    EXPECT_TRUE(driver.waitFor([&] {
        const bool seen = view(driver).rect().contains(pixel(0)) && view(driver).rect().contains(pixel(2));
        return seen && (pixel(0) - pixel(2)).manhattanLength() > 1.2 * apart;
    }));

    const std::vector<NamedPin> all = pins(driver);
    driver.press("Del");
    ASSERT_EQ(pins(driver).size(), 2U);
    EXPECT_EQ(pins(driver)[0], all[1]);
    EXPECT_EQ(pins(driver)[1], all[3]);
    EXPECT_EQ(page(driver), u"pins"_s);
    driver.press("Ctrl+Z");
    EXPECT_EQ(pins(driver), all);
}

TEST(Choosing, ABoxTakesThePinsInItAndKeysCombineIt) {
    WindowDriver driver;
    withFourPins(driver);
    const auto at = [&](int pin) {
        return view(driver).pixelOf(pins(driver)[static_cast<std::size_t>(pin)].point);
    };
    const auto boxOver = [&](int first, int last, Qt::KeyboardModifiers keys) {
        const QRect box = QRect(at(first), at(last)).normalized().adjusted(-16, -16, 16, 16);
        drawBox(driver, box.topLeft(), box.bottomRight(), keys);
    };
    boxOver(0, 1, {});
    EXPECT_EQ(chosenDiscs(driver), (std::vector{0, 1}));
    boxOver(2, 3, Qt::ShiftModifier);
    EXPECT_EQ(chosenDiscs(driver), (std::vector{0, 1, 2, 3}));
    boxOver(1, 2, Qt::AltModifier);
    EXPECT_EQ(chosenDiscs(driver), (std::vector{0, 3}));
    const QString before = page(driver);
    drawBox(driver, {40, 300}, {60, 320});
    EXPECT_EQ(page(driver), before) << "a box about nothing changes nothing";
    EXPECT_EQ(steps(driver), 1U);
}

TEST(Choosing, SeveralRegionsInTheTreeTakeOneWeightAndGoTogether) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    std::vector<ImportantRegion> regions;
    for (int i = 0; i < 4; ++i)
        regions.push_back(weighing({"Region " + std::to_string(i + 1), {i}, {2}, 0}, i < 2 ? 2 : 8));
    driver.bench().document().edit(u"Regions"_s,
                                   withImportance(driver.bench().document().committed(), regions));
    QTest::qWait(100);
    driver.selectRow("region-0");
    clickRow(driver, u"region-2"_s, Qt::ShiftModifier);
    EXPECT_EQ(page(driver), u"region-0 region-1 region-2"_s) << "Shift takes all up to it";
    clickRow(driver, u"region-1"_s, Qt::AltModifier);
    EXPECT_EQ(chosenIds(page(driver)).size(), 2);
    clickRow(driver, u"region-3"_s, Qt::ControlModifier);
    EXPECT_EQ(chosenIds(page(driver)).size(), 3);
    EXPECT_TRUE(field(driver, "field-region-weight").mixed());
    driver.shot("41-regions-chosen");
    driver.type("field-region-weight", "16");
    const auto& weighed = driver.bench().project().importance;
    EXPECT_EQ(heaviest(weighed[0]), 16);
    EXPECT_EQ(heaviest(weighed[1]), 2);
    EXPECT_EQ(heaviest(weighed[2]), 16);
    EXPECT_EQ(heaviest(weighed[3]), 16);
    EXPECT_EQ(steps(driver), 2U);
    driver.window().findChild<ProjectTree*>()->setFocus();
    driver.press("Del");
    ASSERT_EQ(driver.bench().project().importance.size(), 1U);
    EXPECT_EQ(driver.bench().project().importance[0].name, "Region 2");
    EXPECT_EQ(steps(driver), 3U);

    // Rows of which only one can be chosen do not join.
    driver.press("Ctrl+Z");
    driver.selectRow("region-0");
    clickRow(driver, u"plane"_s, Qt::ControlModifier);
    EXPECT_EQ(page(driver), u"plane"_s);
    EXPECT_EQ(driver.window().findChild<ProjectTree*>()->selectionModel()->selectedRows().size(), 1);
}

TEST(Choosing, RegionsAreTakenInTheViewByClickAndBox) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.window().actions()[u"front"_s]->trigger();
    const IndexedMesh& part = *driver.bench().project().part;
    const Eigen::AlignedBox3d box = driver.bench().figures(driver.bench().project().part).box;
    const auto middle = [&](int f) -> Eigen::Vector3d {
        return (part.corner(f, 0) + part.corner(f, 1) + part.corner(f, 2)) / 3;
    };
    // A quarter of the part at the left and one at the right; what is nearest in each, seen from the front.
    std::vector<ImportantRegion> regions{{"Left", {}, {}, 0}, {"Right", {}, {}, 0}};
    std::array<int, 2> nearest{-1, -1};
    for (int f = 0; f < part.faceCount(); ++f) {
        const double across = (middle(f).x() - box.min().x()) / box.sizes().x();
        if (across > 0.25 && across < 0.75)
            continue;
        const std::size_t side = across < 0.5 ? 0 : 1;
        regions[side].faces.push_back(f);
        regions[side].weights.push_back(4);
        if (nearest[side] < 0 || middle(f).y() < middle(nearest[side]).y())
            nearest[side] = f;
    }
    driver.bench().document().edit(u"Regions"_s,
                                   withImportance(driver.bench().document().committed(), regions));
    ASSERT_TRUE(driver.waitIdle());
    QTest::qWait(500);
    const auto clickAt = [&](const Eigen::Vector3d& place, Qt::KeyboardModifiers keys) {
        QTest::mouseClick(&view(driver), Qt::LeftButton, keys, view(driver).pixelOf(place));
        QTest::qWait(60);
    };
    driver.selectRow("part");
    clickAt(middle(nearest[0]), {});
    EXPECT_EQ(page(driver), u"part"_s) << "regions are not in view";
    driver.selectRow("importance");
    clickAt(middle(nearest[0]), {});
    EXPECT_EQ(page(driver), u"region-0"_s);
    clickAt(middle(nearest[1]), {});
    EXPECT_EQ(page(driver), u"region-1"_s);
    clickAt(middle(nearest[0]), Qt::ControlModifier);
    EXPECT_EQ(page(driver), u"region-1 region-0"_s);
    clickAt(box.center() - Eigen::Vector3d(0, box.sizes().y() / 2, 0), {});
    EXPECT_EQ(page(driver), u"region-1 region-0"_s) << "no region there";
    driver.shot("41-regions-in-view");
    driver.selectRow("importance");
    drawBox(driver, {8, 60}, {view(driver).width() - 8, view(driver).height() - 40});
    EXPECT_EQ(chosenIds(page(driver)).size(), 2);
}

TEST(Choosing, SeveralFeaturesAreGivenBackInOneStep) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(180000));
    MoldSettings mold = driver.bench().project().mold;
    mold.spout.on = true;
    mold.keys.count = 4;
    driver.bench().document().edit(u"Features"_s, withMoldSettings(driver.bench().project(), mold));
    driver.selectRow("mold");
    auto& placing = driver.bench().placing();
    ASSERT_TRUE(driver.waitFor([&] { return placing.row(Placeable::Key, 3) != nullptr; }));
    for (const int key : {0, 1, 2})
        placing.place(placing.row(Placeable::Key, key)->stands, {}, false);
    QTest::qWait(200);
    const std::size_t before = steps(driver);
    driver.selectRow("feature-key-0");
    clickRow(driver, featureId(Placeable::Key, 2), Qt::ControlModifier);
    const auto shown = [&] {
        return std::ranges::count(view(driver).scene().features().plan().features, true,
                                  &scene::ShownFeature::chosen);
    };
    EXPECT_TRUE(driver.waitFor([&] { return shown() == 2; }));
    driver.shot("52-features-chosen");
    driver.window().actions()[u"place-automatically"_s]->trigger();
    EXPECT_EQ(steps(driver), before + 1);
    ASSERT_EQ(driver.bench().project().mold.placed.size(), 1U);
    EXPECT_EQ(driver.bench().project().mold.placed[0].number, 1);
}

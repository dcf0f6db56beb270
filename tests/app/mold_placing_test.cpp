// SPDX-License-Identifier: AGPL-3.0-or-later
// Features of the mold placed by hand in the real window: dragged, refused in words, typed, given back,
// undone.
#include "app/window_driver.h"

#include "project/edits.h"
#include "theme/theme.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/main_window.h"
#include "window/mold_feature_pages.h"
#include "window/mold_placing.h"
#include "window/placing_snap.h"
#include "window/workbench.h"

#include <QMouseEvent>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>

using namespace moldwright;
using namespace Qt::StringLiterals;
using Eigen::Vector2d;
using test::WindowDriver;

namespace {

/// A finished cast with a spout, vents, keys, slits, bolts and an ejector hole, its plan in view from above.
void showPlan(WindowDriver& driver) {
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(180000));
    ASSERT_TRUE(driver.bench().castIsProved());
    MoldSettings mold = driver.bench().project().mold;
    mold.spout.on = mold.vents.on = true;
    mold.keys.count = 4;
    mold.slits.count = mold.bolts.count = 2;
    driver.bench().document().edit(u"Features"_s, withMoldSettings(driver.bench().project(), mold));
    driver.selectRow("mold");
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().placing().rows().size() >= 9; }));
    driver.window().actions()[u"along-normal"_s]->trigger();
    QTest::qWait(400);
    driver.window().actions()[u"fit"_s]->trigger();
    QTest::qWait(400);
}

Eigen::Vector3d inPart(WindowDriver& driver, const Vector2d& place) {
    const MoldSketch& sketch = *driver.bench().placing().sketch();
    return sketch.partToMold.inverse() * Eigen::Vector3d(place.x(), place.y(), 0);
}

void moveTo(PartView& view, const QPoint& place) {
    QMouseEvent move(QEvent::MouseMove, QPointF(place), QPointF(view.mapToGlobal(place)), Qt::NoButton,
                     Qt::LeftButton, {});
    QCoreApplication::sendEvent(&view, &move);
}

const PlacedRow& rowOf(WindowDriver& driver, Placeable kind, int number) {
    return *driver.bench().placing().row(kind, number);
}

/// Waits until the answer is that of the settings in view.
bool answered(WindowDriver& driver) {
    return driver.waitFor([&] {
        const MoldSketch* sketch = driver.bench().placing().sketch();
        return !driver.bench().placing().refusal().isEmpty() ||
               (sketch != nullptr && sketch->settings == driver.bench().project().mold);
    });
}

/// Presses on a feature's disc and moves to a place of the mold, in steps; the button stays down.
void dragTo(WindowDriver& driver, const PlacedRow& row, const Vector2d& place) {
    PartView& view = driver.window().view();
    const QPoint from = view.pixelOf(inPart(driver, row.stands.place + row.copies.front()->origin));
    const QPoint to = view.pixelOf(inPart(driver, place));
    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 8; ++step) {
        moveTo(view, from + (to - from) * step / 8);
        QTest::qWait(20);
    }
}

void drop(WindowDriver& driver, const Vector2d& place) {
    PartView& view = driver.window().view();
    QTest::mouseRelease(&view, Qt::LeftButton, {}, view.pixelOf(inPart(driver, place)));
    QTest::qWait(60);
}

} // namespace

TEST(MoldPlacing, AKeyIsDraggedToldOfInRedAndUndoneInOneStep) {
    WindowDriver driver;
    ASSERT_NO_FATAL_FAILURE(showPlan(driver));
    driver.shot("85-plan");
    const std::size_t steps = driver.bench().document().history().steps().size();
    const Vector2d before = rowOf(driver, Placeable::Key, 1).stands.place;
    ASSERT_FALSE(rowOf(driver, Placeable::Key, 1).failing());

    // Half way to the cavity: too near.
    const Vector2d near = 0.35 * before;
    dragTo(driver, rowOf(driver, Placeable::Key, 1), near);
    ASSERT_TRUE(answered(driver));
    driver.waitFor([&] { return rowOf(driver, Placeable::Key, 1).failing(); }, 3000);
    EXPECT_TRUE(rowOf(driver, Placeable::Key, 1).failing());
    QTest::qWait(100);
    driver.shot("86-plan-drag-failing");
    EXPECT_EQ(driver.bench().document().history().steps().size(), steps) << "no step while it is dragged";
    EXPECT_TRUE(driver.bench().document().committed().mold.placed.empty());
    const auto chips = featureChips(driver.bench(), featureId(Placeable::Key, 1));
    ASSERT_FALSE(chips.empty());
    const auto told = std::ranges::find_if(chips, [](const scene::Chip& chip) {
        return chip.content.lines.front().runs.front().text == "Key 2";
    });
    ASSERT_NE(told, chips.end());
    EXPECT_EQ(told->content.lines.front().runs.back().ink, scene::Ink::Error);
    EXPECT_NE(told->content.lines.front().runs.back().text.find("asked for"), std::string::npos);

    // Back out, and let go.
    const Vector2d target = before + Vector2d(before.x() > 0 ? 3 : -3, 0);
    PartView& view = driver.window().view();
    moveTo(view, view.pixelOf(inPart(driver, target)));
    drop(driver, target);
    ASSERT_TRUE(answered(driver));
    EXPECT_EQ(driver.bench().document().history().steps().size(), steps + 1);
    ASSERT_EQ(driver.bench().project().mold.placed.size(), 1U);
    EXPECT_LT((driver.bench().project().mold.placed.front().place - target).norm(), 1.5);
    EXPECT_TRUE(rowOf(driver, Placeable::Key, 1).byHand);
    EXPECT_FALSE(rowOf(driver, Placeable::Key, 1).failing());
    driver.shot("87-plan-placed");
    driver.press("Ctrl+Z");
    ASSERT_TRUE(answered(driver));
    EXPECT_TRUE(driver.bench().project().mold.placed.empty());
    EXPECT_EQ(rowOf(driver, Placeable::Key, 1).stands.place, before);
}

TEST(MoldPlacing, EscGivesADragUp) {
    WindowDriver driver;
    ASSERT_NO_FATAL_FAILURE(showPlan(driver));
    const Vector2d before = rowOf(driver, Placeable::Bolt, 0).stands.place;
    dragTo(driver, rowOf(driver, Placeable::Bolt, 0), before + Vector2d(4, 6));
    driver.press("Esc");
    drop(driver, before + Vector2d(4, 6));
    ASSERT_TRUE(answered(driver));
    EXPECT_TRUE(driver.bench().project().mold.placed.empty());
    EXPECT_EQ(rowOf(driver, Placeable::Bolt, 0).stands.place, before);
}

TEST(MoldPlacing, TheSpoutSlidesAlongItsFaceAndIsRefusedBesideTheCavity) {
    WindowDriver driver;
    ASSERT_NO_FATAL_FAILURE(showPlan(driver));
    const Vector2d before = rowOf(driver, Placeable::Spout, 0).stands.place;
    dragTo(driver, rowOf(driver, Placeable::Spout, 0), before + Vector2d(300, 0));
    ASSERT_TRUE(driver.waitFor([&] { return !driver.bench().placing().refusal().isEmpty(); }));
    EXPECT_TRUE(driver.bench().placing().refusal().contains(u"from the middle"_s));
    QTest::qWait(100);
    driver.shot("88-plan-refused");
    driver.press("Esc");
    drop(driver, before);
    ASSERT_TRUE(answered(driver));
    EXPECT_TRUE(driver.bench().placing().refusal().isEmpty());
}

TEST(MoldPlacing, ExactPlacesAreTypedBuiltAndGivenBack) {
    WindowDriver driver;
    ASSERT_NO_FATAL_FAILURE(showPlan(driver));
    driver.selectRow("feature-slit-0");
    driver.type("field-feature-y", "-4.25");
    ASSERT_TRUE(answered(driver));
    const PlacedFeatures& placed = driver.bench().project().mold.placed;
    ASSERT_EQ(placed.size(), 1U);
    EXPECT_EQ(placed.front().place.y(), -4.25);
    driver.selectRow("feature-key-1");
    const Vector2d key = rowOf(driver, Placeable::Key, 1).stands.place + Vector2d(0, 2);
    driver.type("field-feature-y", QByteArray::number(key.y(), 'f', 2).constData());
    ASSERT_TRUE(answered(driver));
    EXPECT_NEAR(rowOf(driver, Placeable::Key, 1).stands.place.y(), key.y(), 0.01);
    driver.window().setFocus();
    driver.press("Ctrl+M");
    ASSERT_TRUE(driver.waitIdle(180000));
    ASSERT_TRUE(driver.bench().moldIsCurrent());
    const auto slit = std::ranges::find_if(driver.bench().mold()->features, [](const MoldFeature& feature) {
        return feature.kind == "slit" && feature.stands->number == 0;
    });
    EXPECT_EQ(slit->place.y(), -4.25);
    EXPECT_EQ(driver.bench().placing().sketch()->steel, driver.bench().mold()->steelOfEach);
    driver.selectRow("feature-slit-0");
    ASSERT_TRUE(driver.window().actions()[u"place-automatically"_s]->isEnabled());
    driver.window().actions()[u"place-automatically"_s]->trigger();
    QTest::qWait(60);
    EXPECT_EQ(driver.bench().project().mold.placed.size(), 1U);
    EXPECT_FALSE(driver.window().actions()[u"place-automatically"_s]->isEnabled());
    driver.window().actions()[u"place-all-automatically"_s]->trigger();
    EXPECT_TRUE(driver.bench().project().mold.placed.empty());
}

TEST(MoldPlacing, ThePlanInTheDarkTheme) {
    WindowDriver driver;
    ASSERT_NO_FATAL_FAILURE(showPlan(driver));
    driver.window().actions()[u"theme-dark"_s]->trigger();
    const Vector2d key = rowOf(driver, Placeable::Key, 0).stands.place;
    driver.bench().placing().place({Placeable::Key, 0, 0.6 * key}, {}, false);
    driver.selectRow("feature-key-0");
    ASSERT_TRUE(answered(driver));
    QTest::qWait(300);
    driver.shot("89-plan-dark");
    driver.window().actions()[u"theme-light"_s]->trigger();
    EXPECT_TRUE(rowOf(driver, Placeable::Key, 0).byHand);
}

TEST(PlacingSnap, LinesUpWithOthersAndTheirMirrorsElseInHalfMillimetres) {
    PlacedRow dragged;
    dragged.stands = {Placeable::Key, 0, {0, 0}};
    PlacedRow other;
    other.stands = {Placeable::Bolt, 0, {20.3, 11.1}};
    PlacedRow pin;
    pin.stands = {Placeable::Ejector, 0, {7.7, 7.7}};
    const std::vector<PlacedRow> rows = {dragged, other, pin};
    EXPECT_EQ(snapped({20.9, 11.9}, dragged, rows, 1), Vector2d(20.3, 11.1));
    EXPECT_EQ(snapped({-19.6, -0.3}, dragged, rows, 1), Vector2d(-20.3, 0));
    EXPECT_EQ(snapped({7.8, 7.4}, dragged, rows, 1), Vector2d(8, 7.5)) << "a pin counts from elsewhere";
    EXPECT_EQ(snapped({20.9, 11.9}, dragged, rows, 0.1), Vector2d(21, 12));
}

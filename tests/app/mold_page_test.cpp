// SPDX-License-Identifier: AGPL-3.0-or-later
// The mold's settings on its page: chosen, built with, undone.
#include "app/window_driver.h"

#include "panels/property_panel.h"
#include "panels/steel_table.h"
#include "support/folders.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/main_window.h"
#include "window/mold_pages.h"
#include "window/workbench.h"

#include <QComboBox>
#include <QInputDialog>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>

using namespace moldwright;
using namespace Qt::StringLiterals;
using test::WindowDriver;

namespace {

/// Chooses an entry of the list with this object name by keys.
void choose(WindowDriver& driver, const char* field, int index) {
    auto* box = driver.window().findChild<QComboBox*>(QString::fromLatin1(field));
    ASSERT_NE(box, nullptr) << field;
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Home);
    for (int i = 0; i < index; ++i)
        QTest::keyClick(box, Qt::Key_Down);
    QTest::qWait(30);
    ASSERT_EQ(box->currentIndex(), index);
}

long count(const Mold& mold, const std::string& kind) {
    return std::ranges::count(mold.features, kind, &MoldFeature::kind);
}

} // namespace

TEST(MoldPage, EveryValueGoesIntoTheSettingsAndComesBack) {
    Project project;
    const PropertyPage page = [] {
        WindowDriver driver;
        return moldPage(driver.bench(), driver.window().actions());
    }();
    int fields = 0;
    for (const PropertySection& section : page.sections)
        for (const Property& row : section.rows) {
            if (row.id == u"preset"_s || row.id == u"material"_s)
                continue;
            QVariant value;
            if (const auto* number = std::get_if<NumberProperty>(&row.kind))
                value = number->minimum + number->step;
            else if (const auto* choice = std::get_if<ChoiceProperty>(&row.kind))
                value = static_cast<double>(choice->choices.size() - 1);
            else if (std::holds_alternative<TextProperty>(row.kind))
                value = u"80, 120.5"_s;
            else
                continue;
            ++fields;
            if (!withMoldValue(project, row.id, value))
                value = 0.0; // the last choice is what a mold has as it stands
            const auto changed = withMoldValue(project, row.id, value);
            ASSERT_TRUE(changed) << row.id.toStdString();
            EXPECT_FALSE(withMoldValue(*changed, row.id, value)) << row.id.toStdString() << " twice";
        }
    EXPECT_EQ(fields, 75);
    EXPECT_FALSE(withMoldValue(project, u"draft"_s, 3));
}

TEST(MoldPage, ShrinkIsOneNumberUntilAnAxisDiffers) {
    Project project;
    const auto set = [&](const QString& id, double value) { project = *withMoldValue(project, id, value); };
    set(u"shrink"_s, 2);
    EXPECT_EQ(project.mold.shrink.percent, Eigen::Vector3d(2, 2, 2));
    set(u"shrink-z"_s, 1);
    set(u"shrink"_s, 3);
    EXPECT_EQ(project.mold.shrink.percent, Eigen::Vector3d(3, 2, 1));
}

TEST(MoldPage, PresetsAreSavedTakenOverAndRemoved) {
    const test::ScratchFolder config;
    const QByteArray before = qgetenv("XDG_CONFIG_HOME");
    qputenv("XDG_CONFIG_HOME", config.path().c_str());
    {
        WindowDriver driver;
        ASSERT_TRUE(driver.openSample("praline"));
        driver.selectRow("mold");
        driver.type("field-wall", "9");
        driver.type("field-bed-x", "220");
        driver.click("button-save-preset");
        auto* dialog = driver.window().findChild<QInputDialog*>(u"preset-name"_s);
        ASSERT_NE(dialog, nullptr);
        dialog->setTextValue(u"Our press"_s);
        dialog->accept();
        QTest::qWait(100);
        EXPECT_TRUE(std::filesystem::exists(config.path() / "moldwright/presets/Our press.json"));
        ASSERT_NO_FATAL_FAILURE(choose(driver, "choice-preset", 1)); // shown already: it is what is set
        driver.type("field-wall", "4");
        auto* box = driver.window().findChild<QComboBox*>(u"choice-preset"_s);
        EXPECT_EQ(box->currentIndex(), 0);
        ASSERT_NO_FATAL_FAILURE(choose(driver, "choice-preset", 1));
        EXPECT_EQ(driver.bench().project().mold.wall, 9);
        driver.shot("mold-preset");
        driver.press("Ctrl+Z");
        EXPECT_EQ(driver.bench().project().mold.wall, 4) << "one step";
        driver.press("Ctrl+Shift+Z");
        driver.click("button-remove-preset");
        EXPECT_TRUE(std::filesystem::is_empty(config.path() / "moldwright/presets"));
        EXPECT_EQ(driver.bench().project().mold.wall, 9);
    }
    qputenv("XDG_CONFIG_HOME", before);
}

TEST(MoldPage, FeaturesAreChosenBuiltAndUndone) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(180000));
    ASSERT_TRUE(driver.bench().castIsProved());
    driver.selectRow("mold");
    const MoldSettings plain = driver.bench().project().mold;
    driver.type("field-columns", "2");
    driver.type("field-shrink", "1.5");
    ASSERT_NO_FATAL_FAILURE(choose(driver, "choice-spout", 1));
    ASSERT_NO_FATAL_FAILURE(choose(driver, "choice-vents", 1));
    driver.type("field-overflows", "1");
    driver.type("field-keys", "4");
    driver.type("field-slits", "2");
    const MoldSettings& settings = driver.bench().project().mold;
    EXPECT_EQ(settings.layout.columns, 2);
    EXPECT_EQ(settings.shrink.percent, Eigen::Vector3d::Constant(1.5));
    EXPECT_TRUE(settings.spout.on && settings.vents.on);
    driver.window().setFocus();
    driver.press("Ctrl+M");
    ASSERT_TRUE(driver.waitIdle(180000));
    ASSERT_TRUE(driver.bench().moldIsCurrent());
    const Mold& mold = *driver.bench().mold();
    EXPECT_TRUE(mold.verified());
    EXPECT_EQ(mold.cavities, 2);
    EXPECT_EQ(count(mold, "spout"), 1);
    EXPECT_EQ(count(mold, "overflow"), 2);
    EXPECT_EQ(count(mold, "key"), 4);
    EXPECT_EQ(count(mold, "slit"), 2);
    QTest::qWait(900); // it opens
    driver.shot("80-mold-features");

    // The steel between features: listed thinnest first, and shown by a click.
    auto& table = *driver.window().findChild<SteelTable*>();
    ASSERT_TRUE(table.isVisible()) << "building brings it to the front";
    ASSERT_FALSE(table.rows().empty());
    EXPECT_NEAR(table.rows().front().steel, mold.minWall, 1e-9);
    EXPECT_TRUE(std::ranges::is_sorted(table.rows(), {}, &SteelRow::steel));
    EXPECT_TRUE(std::ranges::none_of(table.rows(), &SteelRow::failing));
    PartView& view = driver.window().view();
    const double before = view.camera().halfHeight();
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualItemRect(table.item(0, 0)).center());
    QTest::qWait(400);
    const Eigen::Vector3d place =
        view.scene().placeOnHalf(mold.minWallPlace.z() > 0 ? 1 : 2, mold.minWallPlace);
    EXPECT_LT((view.camera().focus - place).norm(), view.camera().halfHeight());
    EXPECT_LT(view.camera().halfHeight(), before);
    driver.shot("80-mold-steel");
    // Each was a step of its own.
    for (int step = 0; step < 7; ++step)
        driver.press("Ctrl+Z");
    EXPECT_EQ(driver.bench().project().mold, plain);
    EXPECT_FALSE(driver.bench().moldIsCurrent());
}

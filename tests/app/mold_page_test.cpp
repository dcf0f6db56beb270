// SPDX-License-Identifier: AGPL-3.0-or-later
// The mold's settings on its page: chosen, built with, undone.
#include "app/window_driver.h"

#include "panels/property_panel.h"
#include "window/document.h"
#include "window/main_window.h"
#include "window/mold_pages.h"
#include "window/workbench.h"

#include <QComboBox>
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
            double value = 0;
            if (const auto* number = std::get_if<NumberProperty>(&row.kind))
                value = number->minimum + number->step;
            else if (const auto* choice = std::get_if<ChoiceProperty>(&row.kind))
                value = static_cast<double>(choice->choices.size() - 1);
            else
                continue;
            ++fields;
            const auto changed = withMoldValue(project, row.id, value);
            ASSERT_TRUE(changed) << row.id.toStdString();
            EXPECT_FALSE(withMoldValue(*changed, row.id, value)) << row.id.toStdString() << " twice";
        }
    EXPECT_EQ(fields, 19);
    EXPECT_FALSE(withMoldValue(project, u"draft"_s, 3));
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
    EXPECT_EQ(count(mold, "key"), 4);
    EXPECT_EQ(count(mold, "slit"), 2);
    driver.shot("80-mold-features");
    // Each was a step of its own.
    for (int step = 0; step < 6; ++step)
        driver.press("Ctrl+Z");
    EXPECT_EQ(driver.bench().project().mold, plain);
    EXPECT_FALSE(driver.bench().moldIsCurrent());
}

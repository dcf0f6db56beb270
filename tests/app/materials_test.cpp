// SPDX-License-Identifier: AGPL-3.0-or-later
// Materials in the window: chosen for a mold, changed and added in their dialog.
#include "app/window_driver.h"

#include "materials/material_table.h"
#include "support/folders.h"
#include "window/main_window.h"
#include "window/material_dialog.h"
#include "window/workbench.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTest>

#include <gtest/gtest.h>

using namespace moldwright;
using namespace Qt::StringLiterals;
using test::WindowDriver;

namespace {

/// With a folder of settings that belongs to the test.
class Materials : public testing::Test {
protected:
    Materials() : m_before(qgetenv("XDG_CONFIG_HOME")) {
        qputenv("XDG_CONFIG_HOME", m_config.path().c_str());
    }
    ~Materials() override { qputenv("XDG_CONFIG_HOME", m_before); }

    /// Goes to an entry of the row by the arrow keys; the page is laid out anew at each step, and keeps the
    /// focus.
    static void choose(WindowDriver& driver, const QString& name) {
        auto* box = driver.window().findChild<QComboBox*>(u"choice-material"_s);
        ASSERT_NE(box, nullptr);
        const int wanted = box->findText(name);
        ASSERT_GT(wanted, 0);
        box->setFocus();
        for (int i = 0; i <= 30 && box->currentIndex() != wanted; ++i) {
            QTest::keyClick(box, box->currentIndex() < wanted ? Qt::Key_Down : Qt::Key_Up);
            QTest::qWait(20);
            box = driver.window().findChild<QComboBox*>(u"choice-material"_s);
            ASSERT_TRUE(box->hasFocus());
        }
        ASSERT_TRUE(driver.bench().project().mold.material);
        ASSERT_EQ(driver.bench().project().mold.material->name, name.toStdString());
    }

    static MaterialDialog* open(WindowDriver& driver) {
        driver.click("button-edit-materials");
        return driver.window().findChild<MaterialDialog*>(u"materials"_s);
    }

    template <class Widget>
    static Widget* in(const MaterialDialog& dialog, const char* name) {
        auto* widget = dialog.findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(widget, nullptr) << name;
        return widget;
    }

    static void retype(QLineEdit* line, const char* text) {
        line->setFocus();
        line->selectAll();
        QTest::keyClicks(line, QString::fromUtf8(text));
    }

    test::ScratchFolder m_config;
    QByteArray m_before;
};

} // namespace

TEST_F(Materials, BringTheirValuesAndAskForTheirDraft) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.selectRow("mold");
    ASSERT_NO_FATAL_FAILURE(choose(driver, u"Concrete"_s));
    const MoldSettings& mold = driver.bench().project().mold;
    EXPECT_EQ(mold.shrink.percent.y(), 0.04);
    EXPECT_EQ(mold.density, 2.4);
    driver.shot("material");
    driver.click("button-take-material-draft");
    EXPECT_EQ(driver.bench().project().design.draftDegrees, 8);
    driver.press("Ctrl+Z");
    EXPECT_NE(driver.bench().project().design.draftDegrees, 8);
    driver.press("Ctrl+Z");
    EXPECT_FALSE(driver.bench().project().mold.material) << "one step";
    EXPECT_EQ(driver.bench().project().mold.density, 0);
}

TEST_F(Materials, AreChangedAddedAndRemoved) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.selectRow("mold");
    ASSERT_NO_FATAL_FAILURE(choose(driver, u"ABS"_s));
    MaterialDialog* dialog = open(driver);
    ASSERT_NE(dialog, nullptr);
    auto* list = in<QListWidget>(*dialog, "materials-list");
    ASSERT_EQ(list->currentItem()->text(), u"ABS"_s);
    EXPECT_FALSE(in<QWidget>(*dialog, "materials-remove")->isEnabled());
    auto* shrink = in<QAbstractSpinBox>(*dialog, "material-shrink");
    shrink->setFocus();
    shrink->selectAll();
    QTest::keyClicks(shrink, u"0.62\r"_s);
    retype(in<QLineEdit>(*dialog, "material-shrink-source"), "coupon of May");
    QTest::qWait(600);
    const MaterialPlaces places = MaterialPlaces::usual();
    const Result<Material> kept = materialNamed(*materialTable(places), "abs");
    EXPECT_EQ(kept->shrinkPercent.value, 0.62);
    EXPECT_EQ(kept->shrinkPercent.source, "coupon of May");
    EXPECT_EQ(kept->density.source, "makers' data sheets") << "what was not changed stays";
    driver.shot("materials", dialog);
    EXPECT_EQ(driver.bench().project().mold.material->shrinkPercent.value, 0.5) << "a project keeps its own";

    QTest::mouseClick(in<QWidget>(*dialog, "materials-new"), Qt::LeftButton);
    retype(in<QLineEdit>(*dialog, "material-name"), "Soap");
    QTest::mouseClick(in<QWidget>(*dialog, "materials-close"), Qt::LeftButton); // keeps what was just typed
    EXPECT_EQ(materialNamed(*materialTable(places), "soap")->shrinkPercent.value, 0.62);
    QTest::qWait(100);
    ASSERT_NO_FATAL_FAILURE(choose(driver, u"Soap"_s));
    EXPECT_EQ(driver.bench().project().mold.shrink.percent.x(), 0.62);

    dialog = open(driver);
    list = in<QListWidget>(*dialog, "materials-list");
    QTest::mouseClick(in<QWidget>(*dialog, "materials-remove"), Qt::LeftButton);
    EXPECT_EQ(materialNamed(*materialTable(places), "abs")->shrinkPercent.value, 0.5) << "as before";
    in<QLineEdit>(*dialog, "material-name")->setFocus();
    retype(in<QLineEdit>(*dialog, "material-name"), " ");
    QTest::qWait(600);
    EXPECT_NE(in<QLabel>(*dialog, "materials-told")->text(), QString());
    EXPECT_FALSE(ownMaterials(places)->front().name.empty()) << "what cannot be is not kept";
    dialog->close();
}

// SPDX-License-Identifier: AGPL-3.0-or-later
// Preferences, keys and the tour, through the real window.
#include "app/window_driver.h"

#include "panels/command_search.h"
#include "panels/key_sheet.h"
#include "view/part_view.h"
#include "window/document.h"
#include "window/main_window.h"
#include "window/preferences.h"
#include "window/preferences_dialog.h"
#include "window/tour.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

using namespace moldwright;
using namespace Qt::StringLiterals;
using test::WindowDriver;

namespace {

template <class W>
W* in(QWidget* parent, const char* name) {
    return parent->findChild<W*>(QString::fromLatin1(name));
}

PreferencesDialog* openPreferences(WindowDriver& driver) {
    driver.press("Ctrl+,");
    auto* dialog = driver.window().findChild<PreferencesDialog*>();
    QTest::qWait(50);
    return dialog;
}

void giveKeys(PreferencesDialog* dialog, const QString& command, Qt::Key key, Qt::KeyboardModifiers keys) {
    auto* list = in<QTreeWidget>(dialog, "keys-list");
    for (int row = 0; row < list->topLevelItemCount(); ++row)
        if (list->topLevelItem(row)->data(0, Qt::UserRole) == command)
            list->setCurrentItem(list->topLevelItem(row));
    auto* edit = in<QKeySequenceEdit>(dialog, "keys-edit");
    edit->setFocus();
    edit->clear();
    QTest::keyClick(edit, key, keys);
    QTest::qWait(1300); // the field waits for further keys of a sequence
}

/// Puts all preferences back when a test ends.
struct Forgetting {
    ~Forgetting() { QSettings().clear(); }
};

} // namespace

TEST(Keys, AreRemappedEverywhereAtOnceAndKeptUntilReset) {
    const Forgetting forgetting;
    {
        WindowDriver driver;
        ASSERT_TRUE(driver.openSample("praline"));
        PreferencesDialog* dialog = openPreferences(driver);
        ASSERT_TRUE(dialog);
        giveKeys(dialog, u"plane-x"_s, Qt::Key_J, {});
        driver.shot("40-preferences");
        dialog->close();
        QTest::qWait(50);
        const QAction* action = driver.window().actions()[u"plane-x"_s];
        EXPECT_EQ(action->shortcut(), QKeySequence(u"J"_s));
        EXPECT_TRUE(action->toolTip().contains(u"(J)"_s));
        driver.window().view().setFocus();
        driver.press("Shift+X");
        EXPECT_TRUE(driver.bench().document().history().steps().empty()) << "the old key does nothing";
        driver.press("J");
        EXPECT_EQ(driver.bench().document().history().steps().size(), 1U);

        // The key sheet and the search tell the new key.
        driver.press("?");
        auto* sheet = driver.window().findChild<KeySheet*>();
        ASSERT_TRUE(sheet);
        const auto labels = sheet->findChildren<QLabel*>();
        EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* label) { return label->text() == u"J"_s; }));
        sheet->close();
        auto* search = driver.window().findChild<CommandSearch*>();
        driver.press("Ctrl+K");
        QTest::keyClicks(search, u"square x"_s);
        auto* found = search->findChild<QListWidget*>();
        ASSERT_GT(found->count(), 0);
        EXPECT_TRUE(found->item(0)->text().endsWith(u"J"_s)) << found->item(0)->text().toStdString();
        QTest::keyClick(search, Qt::Key_Escape);
    }
    WindowDriver later;
    EXPECT_EQ(later.window().actions()[u"plane-x"_s]->shortcut(), QKeySequence(u"J"_s));
    PreferencesDialog* dialog = openPreferences(later);
    QTest::mouseClick(in<QPushButton>(dialog, "keys-reset-all"), Qt::LeftButton);
    EXPECT_EQ(later.window().actions()[u"plane-x"_s]->shortcut(), QKeySequence(u"Shift+X"_s));
}

TEST(Keys, ThatAnotherCommandHasAreNamedAndNotTaken) {
    const Forgetting forgetting;
    WindowDriver driver;
    PreferencesDialog* dialog = openPreferences(driver);
    ASSERT_TRUE(dialog);
    giveKeys(dialog, u"plane-x"_s, Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(driver.window().actions()[u"plane-x"_s]->shortcut(), QKeySequence(u"Shift+X"_s));
    EXPECT_EQ(driver.window().actions()[u"save"_s]->shortcut(), QKeySequence(u"Ctrl+S"_s));
    const QString words = in<QLabel>(dialog, "keys-conflict")->text();
    EXPECT_TRUE(words.contains(u"Ctrl+S"_s) && words.contains(u"Save"_s)) << words.toStdString();
    driver.shot("41-key-conflict");
}

TEST(Keys, NoTwoCommandsShareThem) {
    WindowDriver driver;
    std::map<QString, QString> owners;
    for (const QAction* action : driver.window().actions().all()) {
        const QString keys = action->shortcut().toString();
        if (keys.isEmpty())
            continue;
        EXPECT_TRUE(owners.emplace(keys, action->objectName()).second)
            << keys.toStdString() << " is of " << owners[keys].toStdString() << " and "
            << action->objectName().toStdString();
    }
}

TEST(Preferences, AreFoundByTheirWords) {
    const Forgetting forgetting;
    WindowDriver driver;
    PreferencesDialog* dialog = openPreferences(driver);
    ASSERT_TRUE(dialog);
    auto* search = in<QLineEdit>(dialog, "preferences-search");
    search->setFocus();
    QTest::keyClicks(search, u"draft req"_s);
    EXPECT_TRUE(in<QDoubleSpinBox>(dialog, "preference-draft")->isVisible());
    EXPECT_FALSE(in<QComboBox>(dialog, "preference-theme")->isVisible());
    search->clear();
    QTest::keyClicks(search, u"blender"_s);
    EXPECT_TRUE(in<QComboBox>(dialog, "preference-navigation")->isVisible());
    search->clear();
    EXPECT_TRUE(in<QComboBox>(dialog, "preference-theme")->isVisible());
}

TEST(Preferences, NewPartsBeginWithTheDefaultsThemeAndMouseFollowAtOnce) {
    const Forgetting forgetting;
    WindowDriver driver;
    PreferencesDialog* dialog = openPreferences(driver);
    ASSERT_TRUE(dialog);
    auto* draft = in<QDoubleSpinBox>(dialog, "preference-draft");
    draft->setFocus();
    draft->selectAll();
    QTest::keyClicks(draft, u"2.5"_s);
    QTest::keyClick(draft, Qt::Key_Tab);
    auto* themes = in<QComboBox>(dialog, "preference-theme");
    themes->setFocus();
    QTest::keyClick(themes, Qt::Key_End);
    QTest::qWait(50);
    EXPECT_TRUE(theme().dark);
    EXPECT_TRUE(driver.window().actions()[u"theme-dark"_s]->isChecked());
    driver.shot("42-preferences-dark");
    auto* schemes = in<QComboBox>(dialog, "preference-navigation");
    schemes->setFocus();
    QTest::keyClick(schemes, Qt::Key_B);
    EXPECT_EQ(preferences::navigation(), schemes->currentData().toString());
    dialog->close();
    ASSERT_TRUE(driver.openSample("praline"));
    EXPECT_EQ(driver.bench().project().design.draftDegrees, 2.5);
    driver.window().actions()[u"theme-light"_s]->trigger();
}

TEST(Tour, LeadsThroughTheJobHoldsNothingUpAndCanBeLeft) {
    WindowDriver driver;
    driver.click("start-tour");
    auto* tour = driver.window().findChild<Tour*>();
    ASSERT_TRUE(tour);
    EXPECT_EQ(tour->step(), 0);
    driver.shot("43-tour-start");
    ASSERT_TRUE(driver.openSample("rabbit"));
    EXPECT_EQ(tour->step(), 1) << "it goes on by itself";
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_EQ(tour->step(), 2);
    driver.shot("44-tour-run");
    driver.click("tour-back");
    EXPECT_EQ(tour->step(), 1);
    driver.click("tour-next");
    driver.click("tour-next");
    EXPECT_EQ(tour->step(), 3);
    driver.window().view().setFocus();
    driver.press("D");
    EXPECT_EQ(tour->step(), 4);
    driver.press("Esc");
    QTest::qWait(50);
    EXPECT_FALSE(driver.window().findChild<Tour*>());
    // It comes back from the menu.
    driver.window().actions()[u"tour"_s]->trigger();
    EXPECT_TRUE(driver.window().findChild<Tour*>());
    driver.click("tour-end");
    QTest::qWait(50);
    EXPECT_FALSE(driver.window().findChild<Tour*>());
}

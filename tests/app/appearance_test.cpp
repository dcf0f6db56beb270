// SPDX-License-Identifier: AGPL-3.0-or-later
// What the window looks like: in both themes, in every language, at two sizes nothing is clipped, nothing
// overlaps, and text can be read. Run once more at twice the scale.
#include "app/window_driver.h"

#include "exchange/mesh_file.h"
#include "panels/figure_table.h"
#include "panels/picture_list.h"
#include "panels/project_tree.h"
#include "panels/property_panel.h"
#include "panels/workflow_bar.h"
#include "project/edits.h"
#include "support/folders.h"
#include "support/shapes.h"
#include "theme/theme.h"
#include "window/document.h"
#include "window/languages.h"
#include "window/main_window.h"
#include "window/preferences_dialog.h"

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QTextDocument>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

using namespace moldwright;
using namespace Qt::StringLiterals;
using test::WindowDriver;

namespace {

constexpr double leastContrast = 4.5;

double luminance(QRgb colour) {
    const auto linear = [](int channel) {
        const double c = channel / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(qRed(colour)) + 0.7152 * linear(qGreen(colour)) + 0.0722 * linear(qBlue(colour));
}

double contrast(double a, double b) {
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

/// The contrast of what is written on a widget, measured on its picture without its outline: the commonest
/// shade is the ground, the ink is what stands out most from it.
double contrastOf(QWidget* widget) {
    constexpr int outline = 3;
    constexpr QRgb shades = 0xF8F8F8; ///< grounds are shaded a little from top to bottom
    const QImage picture = widget->grab().toImage().convertToFormat(QImage::Format_RGB32);
    const int rim = qobject_cast<QLabel*>(widget) ? 0 : outline;
    std::map<QRgb, int> colours;
    for (int y = rim; y < picture.height() - rim; ++y)
        for (int x = rim; x < picture.width() - rim; ++x)
            ++colours[picture.pixel(x, y) & shades];
    if (colours.empty())
        return 21;
    const auto commonest =
        std::ranges::max_element(colours, {}, [](const auto& pair) { return pair.second; });
    const double ground = luminance(commonest->first);
    double most = 1;
    for (const auto& [colour, count] : colours)
        most = std::max(most, contrast(luminance(colour), ground));
    return most;
}

QString plainText(const QLabel* label) {
    if (!Qt::mightBeRichText(label->text()))
        return label->text();
    QTextDocument document;
    document.setHtml(label->text());
    return document.toPlainText();
}

std::string named(const QWidget* widget, const QString& words) {
    return (QString::fromLatin1(widget->metaObject()->className()) + u' ' + widget->objectName() + u": "_s +
            words)
        .toStdString();
}

/// Whether a widget is seen at all: not scrolled away or behind another page.
bool seen(const QWidget* widget) {
    return widget->isVisible() && !widget->visibleRegion().isEmpty();
}

template <class W>
std::vector<W*> seenOf(QWidget& window) {
    std::vector<W*> found;
    for (W* widget : window.findChildren<W*>())
        if (seen(widget))
            found.push_back(widget);
    return found;
}

void expectWordsWhole(QWidget& window, const std::string& where) {
    for (const QLabel* label : seenOf<QLabel>(window)) {
        const QString words = plainText(label);
        if (words.isEmpty() || !label->pixmap().isNull())
            continue;
        const QRect room = label->contentsRect();
        if (label->wordWrap()) {
            EXPECT_GE(label->height() + 1, label->heightForWidth(label->width()))
                << where << named(label, words);
            continue;
        }
        EXPECT_GE(room.width() + 2, label->fontMetrics().horizontalAdvance(words))
            << where << named(label, words);
    }
    for (const QPushButton* button : seenOf<QPushButton>(window))
        EXPECT_GE(button->width() + 1, button->minimumSizeHint().width())
            << where << named(button, button->text());
}

/// What the project's tree tells beside each name.
void expectValuesWhole(const ProjectTree& tree, const QModelIndex& parent, const std::string& where) {
    for (int row = 0; row < tree.model()->rowCount(parent); ++row) {
        const QModelIndex value = tree.model()->index(row, ProjectModel::Value, parent);
        EXPECT_TRUE(tree.fits(value)) << where << value.data().toString().toStdString();
        expectValuesWhole(tree, value.siblingAtColumn(0), where);
    }
}

void expectNothingClipped(QWidget& window, const std::string& where) {
    expectWordsWhole(window, where);
    const auto* verdict = window.findChild<VerdictButton*>();
    EXPECT_TRUE(seen(verdict)) << where;
    EXPECT_GE(verdict->width(), verdict->minimumSizeHint().width()) << where;
    for (const PictureList* list : seenOf<PictureList>(window))
        for (int row = 0; row < list->count(); ++row)
            EXPECT_TRUE(list->fits(row)) << where << named(list, list->item(row)->text());
    if (const auto* tree = window.findChild<ProjectTree*>(); seen(tree))
        expectValuesWhole(*tree, {}, where);
    for (const FigureTable* table : seenOf<FigureTable>(window))
        EXPECT_TRUE(table->fits()) << where << named(table, {});
}

/// No two controls of one panel lie on one another.
void expectNothingOverlaps(QWidget& window, const std::string& where) {
    auto* panel = window.findChild<PropertyPanel*>();
    if (!panel || !seen(panel))
        return;
    const QList<QWidget*> rows = panel->widget()->findChildren<QWidget*>(Qt::FindDirectChildrenOnly);
    for (qsizetype a = 0; a < rows.size(); ++a)
        for (qsizetype b = a + 1; b < rows.size(); ++b)
            if (seen(rows[a]) && seen(rows[b])) {
                EXPECT_FALSE(rows[a]->geometry().intersects(rows[b]->geometry()))
                    << where << named(rows[a], rows[a]->objectName()) << " and " << named(rows[b], {});
            }
    for (const QWidget* row : rows)
        if (seen(row)) {
            EXPECT_LE(row->geometry().right(), panel->viewport()->width()) << where << named(row, {});
        }
}

void expectReadable(QWidget& window, const std::string& where) {
    for (QLabel* label : seenOf<QLabel>(window))
        if (!plainText(label).trimmed().isEmpty() && label->isEnabled()) {
            EXPECT_GE(contrastOf(label), leastContrast) << where << named(label, plainText(label));
        }
    for (QPushButton* button : seenOf<QPushButton>(window))
        if (button->isEnabled()) {
            EXPECT_GE(contrastOf(button), leastContrast) << where << named(button, button->text());
        }
    for (QComboBox* choice : seenOf<QComboBox>(window))
        if (choice->isEnabled()) {
            EXPECT_GE(contrastOf(choice), leastContrast) << where << named(choice, choice->currentText());
        }
}

void expectGoodLooks(WindowDriver& driver, const std::string& where) {
    QTest::qWait(120);
    const std::string before = where + ": ";
    expectNothingClipped(driver.window(), before);
    expectNothingOverlaps(driver.window(), before);
    expectReadable(driver.window(), before);
    driver.shot(("look-" + where).c_str());
}

/// Looks at the preferences, over whatever is open.
void lookAtPreferences(WindowDriver& driver, const std::string& where) {
    driver.press("Ctrl+,");
    QDialog* dialog = nullptr;
    ASSERT_TRUE(driver.waitFor([&] {
        dialog = driver.window().findChild<PreferencesDialog*>();
        return dialog && dialog->isVisible();
    }));
    QTest::qWait(120);
    expectWordsWhole(*dialog, where + ": ");
    expectReadable(*dialog, where + ": ");
    driver.shot(("look-" + where).c_str());
    dialog->close();
    ASSERT_TRUE(driver.waitFor([&] { return !driver.window().findChild<PreferencesDialog*>(); }));
}

/// Looks at the start page with work that was lost on it, then without.
void lookAtStart(WindowDriver& driver, const std::string& language) {
    Project lost;
    lost.name = "Goat head, horns pinned";
    ASSERT_TRUE(RecoveryFolder().write(copyOf(lost, {}, theme().scene)));
    driver.program().recovery().look();
    ASSERT_TRUE(driver.waitFor([&] { return !driver.program().recovery().found().empty(); }));
    for (const bool dark : {false, true}) {
        driver.window().actions()[dark ? u"theme-dark"_s : u"theme-light"_s]->trigger();
        driver.window().resize(1280, 800);
        const std::string theme = dark ? "-dark-" : "-light-";
        expectGoodLooks(driver, language + theme + "start");
        ASSERT_NO_FATAL_FAILURE(lookAtPreferences(driver, language + theme + "preferences"));
    }
    driver.click("lost-discard");
}

/// A mesh that cannot be used, in view.
void openHoled(WindowDriver& driver, const test::ScratchFolder& folder) {
    IndexedMesh holed = test::box({0, 0, 0}, {30, 20, 20});
    holed.F.conservativeResize(holed.F.rows() - 1, 3);
    ASSERT_TRUE(writeMesh(folder.path() / "holed.ply", holed, MeshFormat::Ply));
    driver.answerFileDialog(QString::fromStdString((folder.path() / "holed.ply").string()));
    driver.answerQuestion("leave-discard");
    driver.press("Ctrl+O");
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().refused() != nullptr; }));
}

/// Looks at these pages in a language and a theme.
void lookAround(WindowDriver& driver, const QString& language, bool dark, QSize size,
                const std::vector<const char*>& rows) {
    driver.window().actions()[dark ? u"theme-dark"_s : u"theme-light"_s]->trigger();
    driver.window().resize(size);
    QTest::qWait(100);
    const std::string where = QStringLiteral("%1-%2-%3x-%4-")
                                  .arg(language, dark ? u"dark"_s : u"light"_s)
                                  .arg(driver.window().devicePixelRatioF())
                                  .arg(size.width())
                                  .toStdString();
    for (const char* row : rows) {
        driver.selectRow(row);
        expectGoodLooks(driver, where + row);
        if (testing::Test::HasFailure())
            return; // one page tells enough
    }
}

} // namespace

class Appearance : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Languages, Appearance, testing::Values("en", "de", "zh_CN"));

TEST_P(Appearance, NothingIsClippedOrOverlapsAndTextCanBeRead) {
    WindowDriver driver;
    const QString language = QString::fromLatin1(GetParam());
    driver.program().setLanguage(language);
    QTest::qWait(100);
    ASSERT_NO_FATAL_FAILURE(lookAtStart(driver, GetParam()));
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitIdle(180000));
    MoldSettings mold = driver.bench().project().mold;
    mold.spout.on = mold.vents.on = true;
    mold.keys.count = 4;
    mold.pockets.count = 1;
    mold.pockets.depth = 3; // half 2 is a plate of 5 mm
    driver.bench().document().edit(u"Features"_s, withMoldSettings(driver.bench().project(), mold));
    driver.press("Ctrl+M");
    ASSERT_TRUE(driver.waitIdle());
    ASSERT_TRUE(driver.bench().moldIsCurrent());
    QTest::qWait(900); // the mold opens
    driver.press("Ctrl+D");
    driver.press("Ctrl+PgUp");
    driver.press("Ctrl+Shift+U");
    ASSERT_TRUE(driver.waitIdle());
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)})
        for (const bool dark : {false, true})
            lookAround(driver, language, dark, size,
                       {"part", "variants", "plane", "direction-1", "pins", "importance", "deform",
                        "undercuts", "cast", "feature-spout-0", "feature-pocket-0", "mold"});
    const test::ScratchFolder folder;
    ASSERT_NO_FATAL_FAILURE(openHoled(driver, folder));
    for (const bool dark : {false, true})
        lookAround(driver, language, dark, {1280, 800}, {"refused", "fault-0"});
    driver.window().actions()[u"theme-light"_s]->trigger();
    driver.program().setLanguage(u"en"_s);
}

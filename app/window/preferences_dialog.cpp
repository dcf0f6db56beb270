// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/preferences_dialog.h"

#include "panels/quantity_spin_box.h"
#include "scene/navigation.h"
#include "window/key_table.h"
#include "window/languages.h"
#include "window/preferences.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <set>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr int labelWidth = 150;
constexpr int fieldWidth = 220;

bool fits(const QString& words, const QString& typed) {
    return std::ranges::all_of(typed.split(u' ', Qt::SkipEmptyParts), [&](const QString& part) {
        return words.contains(part, Qt::CaseInsensitive);
    });
}

} // namespace

PreferencesDialog::PreferencesDialog(Actions& actions, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Preferences"));
    resize(640, 620);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    m_search = new QLineEdit(this);
    m_search->setPlaceholderText(tr("Find a preference or a key"));
    m_search->setAccessibleName(m_search->placeholderText());
    m_search->setObjectName(u"preferences-search"_s);
    m_search->setClearButtonEnabled(true);
    column->addWidget(m_search);
    addAppearance(column);
    addDefaults(column);
    m_keys = new KeyTable(actions, this);
    column->addWidget(m_keys, 1);
    m_nothing = new QLabel(tr("No preference has these words."), this);
    m_nothing->setForegroundRole(QPalette::PlaceholderText);
    m_nothing->hide();
    column->addWidget(m_nothing);
    connect(m_search, &QLineEdit::textChanged, this, &PreferencesDialog::search);
}

QFormLayout* PreferencesDialog::addSection(const QString& title, QVBoxLayout* column) {
    auto* section = new QWidget(this);
    section->setObjectName(title);
    auto* form = new QFormLayout(section);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(6);
    auto* heading = new QLabel(title, section);
    QFont bold = heading->font();
    bold.setBold(true);
    heading->setFont(bold);
    form->addRow(heading);
    column->addWidget(section);
    return form;
}

void PreferencesDialog::addRow(QFormLayout* form, const QString& label, QWidget* field,
                               const QString& objectName) {
    auto* words = new QLabel(label, this);
    words->setMinimumWidth(labelWidth);
    words->setBuddy(field);
    field->setObjectName(objectName);
    field->setAccessibleName(label);
    field->setFixedWidth(fieldWidth);
    form->addRow(words, field);
    QWidget* section = form->parentWidget();
    QString searched = section->objectName() + u' ' + label;
    if (const auto* choice = qobject_cast<QComboBox*>(field))
        for (int i = 0; i < choice->count(); ++i)
            searched += u' ' + choice->itemText(i);
    m_rows.push_back({searched, {words, field}, section});
}

void PreferencesDialog::addAppearance(QVBoxLayout* column) {
    QFormLayout* form = addSection(tr("Appearance and mouse"), column);
    auto* themes = new QComboBox(this);
    themes->addItems({tr("Like the desktop"), tr("Light"), tr("Dark")});
    themes->setCurrentIndex(static_cast<int>(preferences::themeChoice()));
    connect(themes, &QComboBox::activated, this,
            [this](int index) { Q_EMIT themeChosen(static_cast<ThemeChoice>(index)); });
    addRow(form, tr("Theme"), themes, u"preference-theme"_s);

    auto* languages = new QComboBox(this);
    languages->addItem(tr("Like the desktop"), QString());
    for (const Language& language : moldwright::languages())
        languages->addItem(language.name, language.code);
    languages->setCurrentIndex(std::max(0, languages->findData(preferences::language())));
    connect(languages, &QComboBox::activated, this,
            [this, languages](int index) { Q_EMIT languageChosen(languages->itemData(index).toString()); });
    addRow(form, tr("Language"), languages, u"preference-language"_s);

    auto* schemes = new QComboBox(this);
    for (const scene::NavigationScheme& scheme : scene::navigationSchemes())
        schemes->addItem(QString::fromStdString(scheme.name), QString::fromStdString(scheme.id));
    schemes->setCurrentIndex(std::max(0, schemes->findData(preferences::navigation())));
    connect(schemes, &QComboBox::activated, this,
            [this, schemes](int index) { Q_EMIT navigationChosen(schemes->itemData(index).toString()); });
    addRow(form, tr("Mouse navigation"), schemes, u"preference-navigation"_s);
}

void PreferencesDialog::addDefaults(QVBoxLayout* column) {
    QFormLayout* form = addSection(tr("New parts begin with"), column);
    const auto number = [&](const QString& label, const QString& unit, double least, double most, double step,
                            double preferences::Defaults::* value, const QString& objectName) {
        auto* field = new QuantitySpinBox(unit, 1, this);
        field->setRange(least, most);
        field->setSingleStep(step);
        field->setValue(preferences::defaults().*value);
        connect(field, &QDoubleSpinBox::valueChanged, this, [value](double typed) {
            preferences::Defaults changed = preferences::defaults();
            changed.*value = typed;
            preferences::setDefaults(changed);
        });
        addRow(form, label, field, objectName);
    };
    number(tr("Draft required"), u"°"_s, 0, 10, 0.1, &preferences::Defaults::draftDegrees,
           u"preference-draft"_s);
    number(tr("Tilt limit"), u"°"_s, 0, 60, 1, &preferences::Defaults::maxTiltDegrees, u"preference-tilt"_s);
    number(tr("Wall of the mold"), u"mm"_s, 1, 25, 0.5, &preferences::Defaults::wall, u"preference-wall"_s);
}

void PreferencesDialog::search(const QString& typed) {
    std::set<QWidget*> sections;
    for (const Row& row : m_rows) {
        const bool shown = fits(row.words, typed);
        for (QWidget* widget : row.widgets)
            widget->setVisible(shown);
        if (shown)
            sections.insert(row.section);
    }
    for (const Row& row : m_rows)
        row.section->setVisible(sections.contains(row.section));
    const bool keys = m_keys->filter(typed) > 0;
    m_keys->setVisible(keys);
    m_nothing->setVisible(!keys && sections.empty());
}

} // namespace moldwright

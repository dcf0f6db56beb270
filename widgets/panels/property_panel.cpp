// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/property_panel.h"

#include "panels/plain_text.h"
#include "panels/quantity_spin_box.h"
#include "theme/icons.h"
#include "theme/theme.h"

#include <QAction>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr int labelWidth = 116;
constexpr int fieldWidth = 92;
constexpr int sliderSteps = 1000;
constexpr int leastWidth = 288;
constexpr int padding = 12;
constexpr int scrollBar = 16;
constexpr int bodyWidth = leastWidth - 2 * padding - scrollBar; ///< what a row can count on
constexpr int buttonGap = 6;

QFrame* hairline(QWidget* parent) {
    auto* line = new QFrame(parent);
    line->setFixedHeight(1);
    line->setAutoFillBackground(true);
    line->setBackgroundRole(QPalette::Midlight);
    return line;
}

QLabel* makeLabel(const QString& text, QWidget* parent, bool bold, int pixels = 12) {
    auto* label = new QLabel(text, parent);
    QFont font = label->font();
    font.setBold(bold);
    font.setPixelSize(pixels);
    label->setFont(font);
    return label;
}

/// Fills the button with the accent colour, or not.
void setFilled(QPushButton* button, bool filled) {
    if (button->property("primary").toBool() == filled)
        return;
    button->setProperty("primary", filled);
    button->updateGeometry(); // a filled button's words are bold
    button->update();
}

/// Whether the button of an action is filled: of tools the one in use, else what is to be done next.
bool isFilled(const QAction* action, const PropertySection& section) {
    if (std::ranges::any_of(section.buttons, &QAction::isChecked))
        return action->isChecked();
    return section.primary && action == section.buttons.front();
}

/// A push button that shows an action of a section: text, icon, tool tip, enabled, as the action says.
QPushButton* actionButton(QAction* action, const PropertySection& section, QWidget* parent) {
    auto* button = new QPushButton(parent);
    button->setProperty("primary", false);
    button->setObjectName(QStringLiteral("button-") + action->objectName());
    button->setMinimumHeight(28);
    const auto follow = [button, action, section] {
        const bool filled = isFilled(action, section);
        setFilled(button, filled);
        button->setText(plainText(action->text()));
        button->setIcon(filled && action->isEnabled()
                            ? tintedIcon(action->property("iconName").toString(), Qt::white)
                            : action->icon());
        button->setEnabled(action->isEnabled());
        button->setVisible(action->isVisible());
        button->setToolTip(action->toolTip());
    };
    follow();
    for (const QAction* any : section.buttons)
        QObject::connect(any, &QAction::changed, button, follow);
    QObject::connect(button, &QPushButton::clicked, action, [action] { action->trigger(); });
    return button;
}

} // namespace

PropertyPanel::PropertyPanel(QWidget* parent) : QScrollArea(parent) {
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setMinimumWidth(leastWidth);
    setAccessibleName(tr("Properties"));
}

void PropertyPanel::showPage(const PropertyPage& page, bool evenIfSame) {
    if (page.id == m_pageId && page.layout == m_layout && !evenIfSame) {
        setOwner(page.owner);
        return;
    }
    m_pageId = page.id;
    m_layout = page.layout;
    m_rows.clear();
    auto* body = new QWidget(this);
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(padding, 10, padding, padding);
    column->setSpacing(6);
    addHead(page, column);
    for (const PropertySection& section : page.sections)
        addSection(section, column);
    column->addStretch(1);
    setWidget(body);
    body->setBackgroundRole(QPalette::Window);
}

void PropertyPanel::addHead(const PropertyPage& page, QVBoxLayout* column) {
    auto* head = new QGridLayout;
    head->setHorizontalSpacing(12);
    head->setVerticalSpacing(0);
    auto* picture = new QLabel(this);
    picture->setPixmap(themeIcon(page.iconName).pixmap(QSize(24, 24), devicePixelRatioF()));
    head->addWidget(picture, 0, 0, 2, 1);
    head->addWidget(makeLabel(page.title, this, true, 15), 0, 1);
    m_owner = makeLabel(page.owner, this, false, 11);
    m_owner->setForegroundRole(QPalette::PlaceholderText);
    m_owner->setWordWrap(true);
    head->addWidget(m_owner, 1, 1);
    head->setColumnStretch(1, 1);
    column->addLayout(head);
}

void PropertyPanel::setOwner(const QString& words) {
    if (m_owner)
        m_owner->setText(words);
}

void PropertyPanel::addSection(const PropertySection& section, QVBoxLayout* column) {
    column->addSpacing(2);
    column->addWidget(hairline(this));
    if (!section.title.isEmpty())
        column->addWidget(makeLabel(section.title, this, true));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnMinimumWidth(0, labelWidth);
    grid->setColumnStretch(1, 1);
    int line = 0;
    for (const Property& property : section.rows) {
        Row row;
        QWidget* editor = makeEditor(property, row);
        if (row.pictures || row.table) {
            grid->addWidget(editor, line++, 0, 1, 2);
            m_rows[property.id] = row;
            continue;
        }
        auto* label = makeLabel(property.label, this, false);
        label->setToolTip(property.help);
        label->setBuddy(row.field  ? static_cast<QWidget*>(row.field)
                        : row.text ? static_cast<QWidget*>(row.text)
                                   : row.choice);
        editor->setToolTip(property.help);
        grid->addWidget(label, line, 0);
        grid->addWidget(editor, line, 1);
        if (row.reading && &property != &section.rows.back())
            grid->addWidget(hairline(this), ++line, 0, 1, 2);
        ++line;
        m_rows[property.id] = row;
    }
    column->addLayout(grid);
    for (const QString& note : section.notes) {
        QLabel* paragraph = makeLabel(note, this, false);
        paragraph->setWordWrap(true);
        paragraph->setTextInteractionFlags(Qt::TextSelectableByMouse);
        column->addWidget(paragraph);
    }
    addButtons(section, column);
}

QWidget* PropertyPanel::makeEditor(const Property& property, Row& row) {
    if (const auto* number = std::get_if<NumberProperty>(&property.kind))
        return makeNumber(property, *number, row);
    if (const auto* choice = std::get_if<ChoiceProperty>(&property.kind))
        return makeChoice(property, *choice, row);
    if (const auto* text = std::get_if<TextProperty>(&property.kind))
        return makeText(property, *text, row);
    if (const auto* pictures = std::get_if<PicturesProperty>(&property.kind))
        return makePictures(property, *pictures, row);
    if (const auto* table = std::get_if<TableProperty>(&property.kind))
        return makeTable(property, *table, row);
    return makeReading(std::get<ReadingProperty>(property.kind), row);
}

QWidget* PropertyPanel::makeTable(const Property& property, const TableProperty& table, Row& row) {
    row.table = new FigureTable(table.rows, this);
    row.table->setAccessibleName(property.label);
    row.table->setObjectName(QStringLiteral("table-") + property.id);
    const QString id = property.id;
    connect(row.table, &FigureTable::chosen, this, [this, id](int column) { Q_EMIT committed(id, column); });
    connect(row.table, &FigureTable::taken, this, [this, id](int column) { Q_EMIT taken(id, column); });
    return row.table;
}

QWidget* PropertyPanel::makePictures(const Property& property, const PicturesProperty& pictures, Row& row) {
    row.pictures = new PictureList(pictures.pictures, this);
    row.pictures->setAccessibleName(property.label);
    row.pictures->setObjectName(QStringLiteral("pictures-") + property.id);
    const QString id = property.id;
    connect(row.pictures, &PictureList::chosen, this, [this, id](int index) { Q_EMIT committed(id, index); });
    return row.pictures;
}

QWidget* PropertyPanel::makeNumber(const Property& property, const NumberProperty& number, Row& row) {
    auto* editor = new QWidget(this);
    auto* line = new QHBoxLayout(editor);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(8);
    row.number = number;
    row.field = new QuantitySpinBox(number.unit, number.decimals, editor);
    row.field->setRange(number.minimum, number.maximum);
    row.field->setSingleStep(number.step);
    row.field->setFixedWidth(fieldWidth);
    row.field->setAccessibleName(property.label);
    row.field->setObjectName(QStringLiteral("field-") + property.id);
    const QString id = property.id;
    connect(row.field, &QDoubleSpinBox::valueChanged, this,
            [this, id](double value) { Q_EMIT committed(id, value); });
    if (number.slider) {
        row.slider = new QSlider(Qt::Horizontal, editor);
        row.slider->setRange(0, sliderSteps);
        row.slider->setPageStep(sliderSteps / 10);
        row.slider->setAccessibleName(property.label);
        line->addWidget(row.slider, 1);
        connectSlider(id, row);
    } else {
        line->addStretch(1);
    }
    line->addWidget(row.field);
    return editor;
}

void PropertyPanel::connectSlider(const QString& id, const Row& row) {
    const auto valueAt = [row](int position) {
        const NumberProperty& n = row.number;
        const double exact = n.minimum + (n.maximum - n.minimum) * position / sliderSteps;
        return std::round(exact / n.step) * n.step;
    };
    connect(row.slider, &QSlider::valueChanged, this, [this, id, row, valueAt](int position) {
        const double value = valueAt(position);
        const QSignalBlocker quiet(row.field);
        row.field->setValue(value);
        if (row.slider->isSliderDown())
            Q_EMIT previewed(id, value);
        else
            Q_EMIT committed(id, value);
    });
    connect(row.slider, &QSlider::sliderReleased, this,
            [this, id, row, valueAt] { Q_EMIT committed(id, valueAt(row.slider->value())); });
}

QWidget* PropertyPanel::makeChoice(const Property& property, const ChoiceProperty& choice, Row& row) {
    row.choice = new QComboBox(this);
    row.choice->addItems(choice.choices);
    row.choice->setFixedHeight(24);
    row.choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    row.choice->setMinimumContentsLength(8);
    row.choice->setAccessibleName(property.label);
    row.choice->setObjectName(QStringLiteral("choice-") + property.id);
    const QString id = property.id;
    connect(row.choice, &QComboBox::activated, this, [this, id](int index) { Q_EMIT committed(id, index); });
    return row.choice;
}

QWidget* PropertyPanel::makeText(const Property& property, const TextProperty& text, Row& row) {
    row.text = new QLineEdit(this);
    row.text->setPlaceholderText(text.placeholder);
    row.text->setFixedHeight(24);
    row.text->setAccessibleName(property.label);
    row.text->setObjectName(QStringLiteral("text-") + property.id);
    const QString id = property.id;
    connect(row.text, &QLineEdit::editingFinished, this,
            [this, id, field = row.text] { Q_EMIT committed(id, field->text()); });
    return row.text;
}

QWidget* PropertyPanel::makeReading(const ReadingProperty& reading, Row& row) {
    auto* editor = new QWidget(this);
    auto* line = new QHBoxLayout(editor);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(8);
    row.reading = makeLabel(QStringLiteral("–"), editor, true);
    row.reading->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row.reading->setTextInteractionFlags(Qt::TextSelectableByMouse);
    row.goal = makeLabel({}, editor, false);
    row.goal->setForegroundRole(QPalette::PlaceholderText);
    row.goal->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row.goal->setMinimumWidth(reading.withGoal ? 48 : 0);
    row.goal->setVisible(reading.withGoal);
    line->addWidget(row.reading, 1);
    line->addWidget(row.goal);
    return editor;
}

void PropertyPanel::addButtons(const PropertySection& section, QVBoxLayout* column) {
    QHBoxLayout* line = nullptr;
    int room = 0;
    for (std::size_t i = 0; i < section.buttons.size(); ++i) {
        const bool first = i == 0 && section.primary;
        QPushButton* button = actionButton(section.buttons[i], section, this);
        const bool alone = first && section.buttons.size() % 2 == 1;
        const int width = button->sizeHint().width();
        if (!line || line->count() == 2 || alone || width > room) {
            line = new QHBoxLayout;
            line->setSpacing(buttonGap);
            column->addLayout(line);
            room = bodyWidth;
        }
        line->addWidget(button, 1);
        room -= width + buttonGap;
        if (alone)
            line = nullptr;
    }
}

void PropertyPanel::setValue(const QString& id, const QVariant& value) {
    const auto found = m_rows.find(id);
    if (found == m_rows.end())
        return;
    const Row& row = found->second;
    if (row.field && !row.field->hasFocus()) {
        const QSignalBlocker quiet(row.field);
        row.field->setMixed(!value.isValid());
        if (value.isValid())
            row.field->setValue(value.toDouble());
    }
    if (row.slider && !row.slider->isSliderDown()) {
        const QSignalBlocker quiet(row.slider);
        const NumberProperty& n = row.number;
        row.slider->setValue(static_cast<int>(
            std::lround((value.toDouble() - n.minimum) / (n.maximum - n.minimum) * sliderSteps)));
    }
    if (row.text && !row.text->hasFocus())
        row.text->setText(value.toString());
    if (row.choice) {
        const QSignalBlocker quiet(row.choice);
        row.choice->setCurrentIndex(value.toInt());
    }
    if (row.pictures)
        row.pictures->setChosen(value.toInt());
    if (row.reading) {
        const QStringList words = value.toStringList();
        row.reading->setText(words.value(0));
        row.goal->setText(words.value(1));
    }
}

void PropertyPanel::setColumns(const QString& id, const std::vector<FigureColumn>& columns, int chosen) {
    if (const auto found = m_rows.find(id); found != m_rows.end() && found->second.table)
        found->second.table->setFigures(columns, chosen);
}

void PropertyPanel::setMissesGoal(const QString& id, bool misses) {
    const auto found = m_rows.find(id);
    if (found == m_rows.end() || !found->second.reading)
        return;
    QPalette palette = found->second.goal->palette();
    palette.setColor(QPalette::WindowText,
                     misses ? theme().error : theme().palette.color(QPalette::WindowText));
    found->second.reading->setPalette(palette);
}

} // namespace moldwright

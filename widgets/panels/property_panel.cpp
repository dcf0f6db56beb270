// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/property_panel.h"

#include "panels/fold.h"
#include "panels/quantity_spin_box.h"
#include "panels/section_buttons.h"
#include "panels/text_field.h"
#include "theme/icons.h"
#include "theme/theme.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QVBoxLayout>

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
    const bool anew = page.id == m_pageId;
    const QString focused = anew ? nameOfFocused() : QString();
    const int scrolled = anew ? verticalScrollBar()->value() : 0;
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
    if (!anew)
        return;
    // Whoever types goes on where they were.
    body->adjustSize();
    verticalScrollBar()->setValue(scrolled);
    if (auto* same = focused.isEmpty() ? nullptr : body->findChild<QWidget*>(focused))
        same->setFocus();
}

QString PropertyPanel::nameOfFocused() const {
    const QWidget* focused = focusWidget();
    return focused != nullptr && focused->hasFocus() && isAncestorOf(focused) ? focused->objectName()
                                                                              : QString();
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
    if (section.folds) {
        const QString id = section.rows.front().id;
        auto* fold = new Fold(section.title, m_unfolded.contains(id), this);
        fold->setObjectName(QStringLiteral("fold-") + id);
        connect(fold, &Fold::toggled, this,
                [this, id](bool open) { open ? void(m_unfolded.insert(id)) : void(m_unfolded.erase(id)); });
        column->addWidget(fold);
        column = fold->content();
    }
    if (!section.folds && !section.title.isEmpty())
        column->addWidget(makeLabel(section.title, this, true));
    addRows(section.rows, column);
    for (const QString& note : section.notes) {
        QLabel* paragraph = makeLabel(note, this, false);
        paragraph->setWordWrap(true);
        paragraph->setTextInteractionFlags(Qt::TextSelectableByMouse);
        column->addWidget(paragraph);
    }
    addSectionButtons(section, bodyWidth, this, column);
}

void PropertyPanel::addRows(const std::vector<Property>& rows, QVBoxLayout* column) {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnMinimumWidth(0, labelWidth);
    grid->setColumnStretch(1, 1);
    int line = 0;
    for (const Property& property : rows) {
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
        if (row.reading && &property != &rows.back())
            grid->addWidget(hairline(this), ++line, 0, 1, 2);
        ++line;
        m_rows[property.id] = row;
    }
    column->addLayout(grid);
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
    row.text = new TextField(this);
    row.text->setPlaceholderText(text.placeholder);
    row.text->setFixedHeight(24);
    row.text->setAccessibleName(property.label);
    row.text->setObjectName(QStringLiteral("text-") + property.id);
    const QString id = property.id;
    connect(row.text, &QLineEdit::editingFinished, this, [this, id, field = row.text] {
        const QString typed = field->text();
        field->setText(typed); // forgets the keys: Undo is the document's from here
        Q_EMIT committed(id, typed);
    });
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

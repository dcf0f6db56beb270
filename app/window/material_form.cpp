// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/material_form.h"

#include "panels/quantity_spin_box.h"
#include "window/sentence.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>

#include <utility>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr int numberWidth = 104;
constexpr int rangeWidth = 110;
constexpr int statusWidth = 150;
constexpr int linesShown = 2;

/// What the table says of a value's trustworthiness; those of the user's own tables are added as they come.
constexpr std::array statuses = {
    MW_TEXT("Materials", "sourced"), MW_TEXT("Materials", "no source"), MW_TEXT("Materials", "make a coupon"),
    MW_TEXT("Materials", "ask the data sheet"), MW_TEXT("Materials", "sources disagree")};

/// What was typed; `known` where that is still what it is shown as.
std::string typed(const QString& text, const std::string& known) {
    return text == sentence(known) ? known : text.trimmed().toStdString();
}

/// Fields side by side.
QHBoxLayout* lineOf(const std::vector<QWidget*>& fields) {
    auto* line = new QHBoxLayout;
    line->setSpacing(8);
    for (QWidget* field : fields)
        line->addWidget(field);
    return line;
}

} // namespace

MaterialForm::MaterialForm(QWidget* parent) : QWidget(parent) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 8, 0);
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(6);
    addWords(form);
    addValues(form);
    addSteps(form);
}

QLineEdit* MaterialForm::makeLine(const QString& name, const QString& id) {
    auto* line = new QLineEdit(this);
    line->setAccessibleName(name);
    line->setObjectName(u"material-"_s + id);
    connect(line, &QLineEdit::textEdited, this, &MaterialForm::tellEdited);
    return line;
}

void MaterialForm::addWords(QFormLayout* form) {
    m_name = makeLine(tr("Name"), u"name"_s);
    m_process = makeLine(tr("Process"), u"process"_s);
    form->addRow(tr("&Name"), m_name);
    form->addRow(tr("&Process"), m_process);
}

MaterialForm::ValueFields MaterialForm::makeValue(const QString& label, const QString& unit, double least,
                                                  double most, int decimals, const QString& id,
                                                  QFormLayout* form) {
    ValueFields fields;
    fields.number = new QuantitySpinBox(unit, decimals, this);
    fields.number->setRange(least, most);
    fields.number->setSingleStep(decimals > 2 ? 0.01 : 0.1);
    fields.number->setFixedWidth(numberWidth);
    fields.number->setAccessibleName(label);
    fields.number->setObjectName(u"material-"_s + id);
    connect(fields.number, &QDoubleSpinBox::valueChanged, this, &MaterialForm::tellEdited);
    fields.range = makeLine(tr("%1, range").arg(label), id + u"-range"_s);
    fields.range->setFixedWidth(rangeWidth);
    fields.source = makeLine(tr("%1, source").arg(label), id + u"-source"_s);
    fields.status = new QComboBox(this);
    fields.status->setAccessibleName(tr("%1, status").arg(label));
    fields.status->setObjectName(u"material-"_s + id + u"-status"_s);
    fields.status->setFixedWidth(statusWidth);
    for (const char* status : statuses)
        fields.status->addItem(sentence(status), QString::fromLatin1(status));
    connect(fields.status, &QComboBox::activated, this, &MaterialForm::tellEdited);
    auto* words = new QLabel(label, this);
    words->setBuddy(fields.number);
    form->addRow(words, lineOf({fields.number, fields.range, fields.source, fields.status}));
    return fields;
}

void MaterialForm::addValues(QFormLayout* form) {
    const auto head = [this](const QString& words, int width) {
        auto* label = new QLabel(words, this);
        label->setForegroundRole(QPalette::PlaceholderText);
        width > 0 ? label->setFixedWidth(width)
                  : label->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        return label;
    };
    form->addRow(QString(), lineOf({head(tr("Value"), numberWidth), head(tr("Range"), rangeWidth),
                                    head(tr("Source"), 0), head(tr("Status"), statusWidth)}));
    m_shrink = makeValue(tr("Shrink"), u"%"_s, -49, 49, 3, u"shrink"_s, form);
    m_draft = makeValue(tr("Draft"), u"°"_s, 0, 44, 2, u"draft"_s, form);
    m_density = makeValue(tr("Density"), u"g/cm³"_s, 0, 29, 3, u"density"_s, form);
    m_vents = makeValue(tr("Vents' depth"), u"mm"_s, 0, 5, 3, u"vents"_s, form);
    m_vents.number->setToolTip(tr("In the parting plane, both halves together; 0: as their width asks."));
    m_formula = new QComboBox(this);
    m_formula->addItems({u"1 + S"_s, u"1 / (1 − S)"_s});
    m_formula->setObjectName(u"material-formula"_s);
    m_formula->setAccessibleName(tr("Made larger by"));
    connect(m_formula, &QComboBox::activated, this, &MaterialForm::tellEdited);
    form->addRow(tr("Made &larger by"), m_formula);
}

void MaterialForm::addSteps(QFormLayout* form) {
    const auto add = [&](const QString& label, const QString& id) {
        auto* field = new QPlainTextEdit(this);
        field->setObjectName(u"material-"_s + id);
        field->setAccessibleName(QString(label).remove(u'&'));
        field->setTabChangesFocus(true);
        field->setFixedHeight(linesShown * field->fontMetrics().lineSpacing() + 12);
        connect(field, &QPlainTextEdit::textChanged, this, &MaterialForm::tellEdited);
        form->addRow(label, field);
        return field;
    };
    m_notes = add(tr("N&otes"), u"notes"_s);
    m_steps = {add(tr("S&ealing"), u"sealing"_s), add(tr("&Release agent"), u"release"_s),
               add(tr("&Filling"), u"filling"_s), add(tr("Se&tting"), u"setting"_s)};
    m_stepsSource = makeLine(tr("Source of these"), u"steps-source"_s);
    form->addRow(tr("Source of these"), m_stepsSource);
}

void MaterialForm::tellEdited() {
    if (!m_filling)
        Q_EMIT edited();
}

void MaterialForm::show(const ValueFields& fields, const MaterialValue& value) {
    fields.number->setValue(value.value);
    fields.range->setText(sentence(value.range));
    fields.source->setText(sentence(value.source));
    const QString status = QString::fromStdString(value.status);
    if (fields.status->findData(status) < 0)
        fields.status->addItem(status, status);
    fields.status->setCurrentIndex(fields.status->findData(status));
    for (QLineEdit* line : {fields.range, fields.source})
        line->setCursorPosition(0);
}

MaterialValue MaterialForm::read(const ValueFields& fields, MaterialValue value) {
    value.value = fields.number->value();
    value.range = typed(fields.range->text(), value.range);
    value.source = typed(fields.source->text(), value.source);
    value.status = fields.status->currentData().toString().toStdString();
    return value;
}

void MaterialForm::setMaterial(const Material& material) {
    m_shown = material;
    m_filling = true;
    m_name->setText(sentence(material.name));
    m_process->setText(sentence(material.process));
    show(m_shrink, material.shrinkPercent);
    show(m_draft, material.draftDegrees);
    show(m_density, material.density);
    show(m_vents, material.ventDepth.value_or(MaterialValue()));
    m_formula->setCurrentIndex(material.divide ? 1 : 0);
    m_notes->setPlainText(sentence(material.notes));
    const Preparation& steps = material.preparation;
    const std::array texts = {&steps.sealing, &steps.release, &steps.filling, &steps.setting};
    for (std::size_t i = 0; i < texts.size(); ++i)
        m_steps[i]->setPlainText(sentence(*texts[i]));
    m_stepsSource->setText(sentence(steps.source));
    m_filling = false;
}

Material MaterialForm::material() const {
    Material material = m_shown;
    material.name = typed(m_name->text(), material.name);
    material.process = typed(m_process->text(), material.process);
    material.shrinkPercent = read(m_shrink, material.shrinkPercent);
    material.draftDegrees = read(m_draft, material.draftDegrees);
    material.density = read(m_density, material.density);
    const MaterialValue vents = read(m_vents, material.ventDepth.value_or(MaterialValue()));
    material.ventDepth = vents.value > 0 ? std::optional(vents) : std::nullopt;
    material.divide = m_formula->currentIndex() == 1;
    material.notes = typed(m_notes->toPlainText(), material.notes);
    Preparation& steps = material.preparation;
    const std::array texts = {&steps.sealing, &steps.release, &steps.filling, &steps.setting};
    for (std::size_t i = 0; i < texts.size(); ++i)
        *texts[i] = typed(m_steps[i]->toPlainText(), *texts[i]);
    steps.source = typed(m_stepsSource->text(), steps.source);
    return material;
}

} // namespace moldwright

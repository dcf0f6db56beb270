// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/import_dialog.h"

#include "mesh/measures.h"
#include "panels/quantity_spin_box.h"
#include "project/placing.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <array>
#include <cmath>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr std::array units = {Unit::Millimetre, Unit::Centimetre, Unit::Metre, Unit::Inch};
constexpr int anotherSize = static_cast<int>(units.size());
constexpr double usualLength = 80; ///< mm, for meshes without a size of their own

} // namespace

SizeGuess guessSize(double longest) {
    if (longest >= 8 && longest <= 1500)
        return {Unit::Millimetre, 1};
    return {Unit::Millimetre, usualLength / longest};
}

ImportDialog::ImportDialog(const OpenedMesh& opened, QWidget* parent) : QDialog(parent) {
    m_size = boundingBox(opened.prepared.mesh).sizes();
    m_longest = m_size.maxCoeff();
    const SizeGuess guess = guessSize(m_longest);
    setWindowTitle(tr("Size of %1").arg(opened.name));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    auto* question =
        new QLabel(tr("This part is %1 units long. What is one unit?").arg(m_longest, 0, 'g', 4), this);
    QFont bold = question->font();
    bold.setBold(true);
    bold.setPixelSize(13);
    question->setFont(bold);
    column->addWidget(question);

    auto* form = new QFormLayout;
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(6);
    m_unit = new QComboBox(this);
    m_unit->addItems({tr("Millimetre"), tr("Centimetre"), tr("Metre"), tr("Inch"), tr("Another size")});
    m_unit->setObjectName(u"import-unit"_s);
    m_length = new QuantitySpinBox(u"mm"_s, 1, this);
    m_length->setRange(0.1, 5000);
    m_length->setObjectName(u"import-length"_s);
    form->addRow(tr("&Unit"), m_unit);
    form->addRow(tr("&Longest side"), m_length);
    m_result = new QLabel(this);
    m_result->setForegroundRole(QPalette::PlaceholderText);
    form->addRow(tr("Size"), m_result);
    column->addLayout(form);

    auto* buttons = new QDialogButtonBox(this);
    auto* open = new QPushButton(tr("Open the part"), buttons);
    open->setProperty("primary", true);
    open->setDefault(true);
    open->setObjectName(u"import-open"_s);
    buttons->addButton(open, QDialogButtonBox::AcceptRole);
    buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_unit, &QComboBox::currentIndexChanged, this, &ImportDialog::unitChosen);
    connect(m_length, &QDoubleSpinBox::valueChanged, this, [this](double length) {
        const Eigen::Vector3d size = m_size * (length / m_longest);
        m_result->setText(
            u"%1 × %2 × %3 mm"_s.arg(size.x(), 0, 'f', 1).arg(size.y(), 0, 'f', 1).arg(size.z(), 0, 'f', 1));
        // The field rounds: only a true difference means that another size was typed.
        if (std::abs(length - m_longest * millimetres(unit())) > 0.051)
            m_unit->setCurrentIndex(anotherSize);
    });
    const int index = guess.scale == 1 ? 0 : anotherSize;
    m_unit->setCurrentIndex(index);
    m_length->setValue(m_longest * guess.scale);
    unitChosen(index);
    open->setFocus();
}

void ImportDialog::unitChosen(int index) {
    if (index != anotherSize)
        m_length->setValue(m_longest * millimetres(units[index]));
}

Unit ImportDialog::unit() const {
    const int index = m_unit->currentIndex();
    return index == anotherSize ? Unit::Millimetre : units[index];
}

double ImportDialog::scale() const {
    return m_unit->currentIndex() == anotherSize ? m_length->value() / m_longest : millimetres(unit());
}

} // namespace moldwright

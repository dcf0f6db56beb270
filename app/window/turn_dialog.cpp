// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/turn_dialog.h"

#include "panels/quantity_spin_box.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr double usualTurn = 15; ///< degrees a step of the field

} // namespace

TurnDialog::TurnDialog(const std::optional<Eigen::Vector3d>& planeNormal, QWidget* parent)
    : QDialog(parent), m_planeNormal(planeNormal.value_or(Eigen::Vector3d::UnitZ())) {
    setWindowTitle(tr("Turn the part"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(6);
    m_axis = new QComboBox(this);
    m_axis->addItems({tr("X axis"), tr("Y axis"), tr("Z axis")});
    if (planeNormal)
        m_axis->addItem(tr("Normal of the parting plane"));
    m_axis->setCurrentIndex(2);
    m_axis->setObjectName(u"turn-axis"_s);
    m_angle = new QuantitySpinBox(u"°"_s, 2, this);
    m_angle->setRange(-360, 360);
    m_angle->setSingleStep(usualTurn);
    m_angle->setObjectName(u"turn-angle"_s);
    form->addRow(tr("&About"), m_axis);
    form->addRow(tr("A&ngle"), m_angle);
    column->addLayout(form);

    auto* buttons = new QDialogButtonBox(this);
    auto* turn = new QPushButton(tr("Turn"), buttons);
    turn->setProperty("primary", true);
    turn->setDefault(true);
    turn->setObjectName(u"turn-accept"_s);
    buttons->addButton(turn, QDialogButtonBox::AcceptRole);
    buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_axis, &QComboBox::currentIndexChanged, this, &TurnDialog::previewed);
    connect(m_angle, &QDoubleSpinBox::valueChanged, this, &TurnDialog::previewed);
    m_angle->setFocus();
    m_angle->selectAll();
}

Eigen::Vector3d TurnDialog::axis() const {
    const int index = m_axis->currentIndex();
    return index < 3 ? Eigen::Vector3d::Unit(index).eval() : m_planeNormal;
}

double TurnDialog::degrees() const {
    return m_angle->value();
}

} // namespace moldwright

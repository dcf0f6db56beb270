// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/view_bar.h"

#include "window/action_table.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QStyle>
#include <QToolButton>
#include <QVariantAnimation>

#include <cmath>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr int openingSteps = 1000;
constexpr int openingMilliseconds = 700;

QFrame* divider(QWidget* parent) {
    auto* line = new QFrame(parent);
    line->setFixedSize(1, 20);
    line->setAutoFillBackground(true);
    line->setBackgroundRole(QPalette::Midlight);
    return line;
}

QLabel* barLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setContentsMargins(6, 0, 4, 0);
    return label;
}

} // namespace

ViewBar::ViewBar(const Actions& actions, QWidget* parent) : QFrame(parent) {
    setFixedHeight(36);
    setAccessibleName(tr("Tools of the view"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 0, 8, 0);
    row->setSpacing(4);
    addTool(actions[u"lay-flat"_s], row);
    row->addWidget(divider(this));
    row->addWidget(barLabel(tr("Show"), this));
    m_mode = new QComboBox(this);
    m_mode->addItems({tr("Undercuts"), tr("Draft map"), tr("Plain")});
    m_mode->setFixedHeight(24);
    m_mode->setMinimumWidth(140);
    m_mode->setAccessibleName(tr("What the faces show"));
    m_mode->setObjectName(u"display-mode"_s);
    connect(m_mode, &QComboBox::activated, this,
            [this](int index) { Q_EMIT modeChosen(static_cast<DisplayMode>(index)); });
    row->addWidget(m_mode);
    row->addWidget(divider(this));
    for (const QString& id : {u"show-plane"_s, u"show-directions"_s, u"show-edges"_s, u"see-through"_s})
        addTool(actions[id], row);
    m_opening = new QSlider(Qt::Horizontal, this);
    m_opening->setRange(0, openingSteps);
    m_opening->setFixedWidth(140);
    m_opening->setAccessibleName(tr("How far the mold is open"));
    m_opening->setObjectName(u"opening"_s);
    connect(m_opening, &QSlider::valueChanged, this, [this] { Q_EMIT openingChanged(opening()); });
    m_moldParts = {divider(this), barLabel(tr("Mold closed"), this), m_opening, barLabel(tr("open"), this)};
    for (QWidget* part : m_moldParts)
        row->addWidget(part);
    row->addStretch(1);
    for (const QString& id : {u"fit"_s, u"perspective"_s, u"screenshot"_s})
        addTool(actions[id], row);
    setMoldShown(false);
}

void ViewBar::addTool(QAction* action, QHBoxLayout* row) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setIconSize({20, 20});
    button->setFixedSize(28, 28);
    button->setAutoRaise(true);
    button->setAccessibleName(action->text().remove(u'&'));
    row->addWidget(button);
}

void ViewBar::setMode(DisplayMode mode) {
    m_mode->setCurrentIndex(static_cast<int>(mode));
}

void ViewBar::setMoldShown(bool shown) {
    for (QWidget* part : m_moldParts)
        part->setVisible(shown);
}

double ViewBar::opening() const {
    return m_opening->value() / double(openingSteps);
}

void ViewBar::easeOpening(double opening) {
    const int target = static_cast<int>(std::lround(opening * openingSteps));
    if (!isVisible() || style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, this) == 0) {
        m_opening->setValue(target);
        return;
    }
    auto* ease = new QVariantAnimation(this);
    ease->setStartValue(m_opening->value());
    ease->setEndValue(target);
    ease->setDuration(openingMilliseconds);
    ease->setEasingCurve(QEasingCurve::InOutCubic);
    connect(ease, &QVariantAnimation::valueChanged, m_opening,
            [this](const QVariant& v) { m_opening->setValue(v.toInt()); });
    ease->start(QAbstractAnimation::DeleteWhenStopped);
}

} // namespace moldwright

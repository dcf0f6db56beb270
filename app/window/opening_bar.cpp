// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/opening_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QStyle>
#include <QVariantAnimation>

#include <cmath>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr int steps = 1000;
constexpr int easeMilliseconds = 700;

} // namespace

OpeningBar::OpeningBar(QWidget* parent) : QFrame(parent) {
    setFixedHeight(32);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Window);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 0, 10, 0);
    row->setSpacing(8);
    auto* label = new QLabel(tr("Open"), this);
    m_slider = new QSlider(Qt::Horizontal, this);
    m_slider->setRange(0, steps);
    m_slider->setPageStep(steps / 20);
    m_slider->setMaximumWidth(280);
    m_slider->setAccessibleName(tr("How far the mold is open"));
    m_slider->setObjectName(u"opening"_s);
    m_words = new QLabel(this);
    row->addWidget(label);
    row->addWidget(m_slider, 1);
    row->addWidget(m_words, 1);
    connect(m_slider, &QSlider::valueChanged, this, [this] {
        tell();
        Q_EMIT openingChanged(opening());
    });
    tell();
}

void OpeningBar::tell() {
    const int at = m_slider->value();
    m_words->setText(at == 0           ? tr("closed")
                     : at < steps / 2  ? tr("opening")
                     : at == steps / 2 ? tr("apart")
                     : at < steps      ? tr("turning over")
                                       : tr("side by side"));
}

double OpeningBar::opening() const {
    return m_slider->value() / double(steps);
}

void OpeningBar::ease(double opening) {
    const int target = static_cast<int>(std::lround(opening * steps));
    if (!isVisible() || style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, this) == 0) {
        m_slider->setValue(target);
        return;
    }
    auto* ease = new QVariantAnimation(this);
    ease->setStartValue(m_slider->value());
    ease->setEndValue(target);
    ease->setDuration(easeMilliseconds);
    ease->setEasingCurve(QEasingCurve::InOutCubic);
    connect(ease, &QVariantAnimation::valueChanged, m_slider,
            [this](const QVariant& v) { m_slider->setValue(v.toInt()); });
    ease->start(QAbstractAnimation::DeleteWhenStopped);
}

} // namespace moldwright

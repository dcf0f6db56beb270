// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/frame_slider.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

namespace moldwright {

FrameSlider::FrameSlider(QWidget* parent)
    : QWidget(parent), m_slider(new QSlider(Qt::Horizontal, this)), m_words(new QLabel(this)) {
    setBackgroundRole(QPalette::Base);
    setAutoFillBackground(true);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 2, 14, 6);
    row->addWidget(m_slider, 1);
    row->addWidget(m_words);
    m_slider->setObjectName(QStringLiteral("frames"));
    m_slider->setAccessibleName(tr("Frames of the run"));
    m_slider->setToolTip(
        tr("Goes back through the run; \"Go on from here\" begins another run from the frame in view."));
    m_words->setForegroundRole(QPalette::PlaceholderText);
    m_words->setMinimumWidth(
        m_words->fontMetrics().horizontalAdvance(tr("Step %1 of %2").arg(8888).arg(8888)));
    m_words->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    connect(m_slider, &QSlider::valueChanged, this, &FrameSlider::chosen);
    hide();
}

void FrameSlider::setSteps(const std::vector<int>& steps, int shown) {
    setVisible(steps.size() > 1);
    if (steps.empty())
        return;
    const QSignalBlocker quiet(m_slider);
    m_slider->setRange(0, static_cast<int>(steps.size()) - 1);
    m_slider->setValue(shown);
    m_words->setText(tr("Step %1 of %2").arg(steps.at(static_cast<std::size_t>(shown))).arg(steps.back()));
}

} // namespace moldwright

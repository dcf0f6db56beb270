// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/section_bar.h"

#include "panels/quantity_spin_box.h"
#include "theme/icons.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include <cmath>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr int sliderSteps = 1000;

QToolButton* barButton(const QString& iconName, const QString& words, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setIcon(themeIcon(iconName));
    button->setIconSize({16, 16});
    button->setAutoRaise(true);
    button->setFixedSize(24, 24);
    button->setToolTip(words);
    button->setAccessibleName(words);
    return button;
}

} // namespace

SectionBar::SectionBar(const QString& name, QWidget* parent) : QFrame(parent) {
    setFixedHeight(32);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Window);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 0, 6, 0);
    row->setSpacing(6);
    row->addWidget(new QLabel(tr("Section"), this));
    m_across = new QComboBox(this);
    m_across->addItems(
        {tr("At the parting plane"), tr("Across X"), tr("Across Y"), tr("Across Z"), tr("Facing the view")});
    m_across->setFixedHeight(24);
    m_across->setAccessibleName(tr("Which way the section lies"));
    m_across->setObjectName(name + u"-section-across"_s);
    m_slider = new QSlider(Qt::Horizontal, this);
    m_slider->setRange(0, sliderSteps);
    m_slider->setPageStep(sliderSteps / 20);
    m_slider->setAccessibleName(tr("How far along the section lies"));
    m_slider->setObjectName(name + u"-section-slider"_s);
    m_offset = new QuantitySpinBox(u"mm"_s, 2, this);
    m_offset->setFixedSize(92, 24);
    m_offset->setRange(-1e6, 1e6);
    m_offset->setAccessibleName(tr("How far along the section lies"));
    m_offset->setObjectName(name + u"-section-offset"_s);
    m_flip = barButton(u"flip"_s, tr("Keep the other side"), this);
    m_flip->setObjectName(name + u"-section-flip"_s);
    QToolButton* close = barButton(u"close"_s, tr("Close the section"), this);
    row->addWidget(m_across);
    row->addWidget(m_slider, 1);
    row->addWidget(m_offset);
    row->addWidget(m_flip);
    row->addWidget(close);
    connect(m_across, &QComboBox::activated, this,
            [this](int across) { choose({static_cast<SectionCut::Across>(across)}); });
    connect(m_slider, &QSlider::valueChanged, this, [this](int position) {
        choose(moved(m_lowest + (m_highest - m_lowest) * position / sliderSteps));
    });
    connect(m_offset, &QuantitySpinBox::valueChanged, this, [this](double offset) { choose(moved(offset)); });
    connect(m_flip, &QToolButton::clicked, this, [this] {
        SectionCut other = m_cut;
        other.flipped = !m_cut.flipped.value_or(false);
        choose(other);
    });
    connect(close, &QToolButton::clicked, this, &SectionBar::closed);
}

SectionCut SectionBar::moved(double offset) const {
    SectionCut cut = m_cut;
    cut.offset = offset;
    return cut;
}

void SectionBar::choose(const SectionCut& cut) {
    setCut(cut);
    Q_EMIT cutChosen(cut);
}

void SectionBar::setCut(const SectionCut& cut) {
    m_cut = cut;
    const QSignalBlocker quiet(m_offset);
    m_across->setCurrentIndex(static_cast<int>(cut.across));
    if (!m_offset->hasFocus() || m_offset->value() != cut.offset)
        m_offset->setValue(cut.offset);
    refreshSlider();
}

void SectionBar::setRange(double lowest, double highest) {
    m_lowest = lowest;
    m_highest = highest;
    m_offset->setSingleStep(std::pow(10, std::floor(std::log10(std::max(highest - lowest, 1e-3)) - 1)));
    refreshSlider();
}

void SectionBar::refreshSlider() {
    if (m_slider->isSliderDown())
        return;
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(
        static_cast<int>(std::lround(sliderSteps * (m_cut.offset - m_lowest) / (m_highest - m_lowest))));
}

} // namespace moldwright

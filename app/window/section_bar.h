// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/display_mode.h"

#include <QFrame>

class QComboBox;
class QSlider;
class QToolButton;

namespace moldwright {

class QuantitySpinBox;

/// The strip over a view that is cut open: which way the section lies, how far along, and which side stays.
class SectionBar : public QFrame {
    Q_OBJECT
public:
    /// `name` goes before the names of its fields.
    SectionBar(const QString& name, QWidget* parent = nullptr);

    void setCut(const SectionCut& cut);
    /// Between which offsets the section meets the part, mm.
    void setRange(double lowest, double highest);

Q_SIGNALS:
    void cutChosen(const moldwright::SectionCut& cut);
    void closed();

private:
    void choose(const SectionCut& cut);
    [[nodiscard]] SectionCut moved(double offset) const;
    void refreshSlider();

    SectionCut m_cut;
    double m_lowest = -100;
    double m_highest = 100;
    QComboBox* m_across;
    QSlider* m_slider;
    QuantitySpinBox* m_offset;
    QToolButton* m_flip;
};

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include <vector>

class QLabel;
class QSlider;

namespace moldwright {

/// Goes back through the frames kept of a run: a slider, and which step is in view.
class FrameSlider : public QWidget {
    Q_OBJECT
public:
    explicit FrameSlider(QWidget* parent = nullptr);

    /// The steps of the frames kept, ascending, and the number of the one in view. Hidden while there is
    /// nothing to go back to.
    void setSteps(const std::vector<int>& steps, int shown);

Q_SIGNALS:
    /// A frame by its number among those kept.
    void chosen(int frame);

private:
    QSlider* m_slider;
    QLabel* m_words;
};

} // namespace moldwright

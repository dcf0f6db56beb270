// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QFrame>

#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace moldwright {

/// A step of the tour: what to do, what to look at, and how one sees that it was done.
struct TourStep {
    QString title;
    QString text;
    QString target; ///< object name of the widget that gets a frame; empty for none
    std::function<bool()> done;
};

/// A card beside the work that leads once through the whole job. It holds nothing up: every control stays in
/// reach, and it goes on by itself once a step was done.
class Tour : public QFrame {
    Q_OBJECT
public:
    Tour(std::vector<TourStep> steps, QWidget* window);
    ~Tour() override;

    /// To be called when anything changed: goes on where the step is done.
    void follow();
    [[nodiscard]] int step() const { return m_step; }

Q_SIGNALS:
    void ended();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void go(int step);
    void place();

    std::vector<TourStep> m_steps;
    int m_step = 0;
    bool m_wasDone = false; ///< as the step began
    QLabel* m_count;
    QLabel* m_title;
    QLabel* m_text;
    QPushButton* m_back;
    QPushButton* m_next;
    QWidget* m_frame; ///< about the step's target
};

} // namespace moldwright

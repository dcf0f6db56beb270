// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QProgressBar>
#include <QTimer>
#include <QWidget>

class QLabel;
class QToolButton;

namespace moldwright {

class Background;

/// The running job in the status bar, from half a second on: bar, what is done, elapsed time, Cancel.
class StatusProgress : public QWidget {
    Q_OBJECT
public:
    StatusProgress(Background& background, QWidget* parent = nullptr);

private:
    void tick();

    Background& m_background;
    QProgressBar* m_bar;
    QLabel* m_words;
    QToolButton* m_cancel;
    QTimer m_clock;
};

} // namespace moldwright

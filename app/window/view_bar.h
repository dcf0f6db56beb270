// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/display_mode.h"

#include <QToolBar>

class QComboBox;
class QLabel;
class QSlider;

namespace moldwright {

class Actions;

/// The tool bar above the view: tools and display left, camera right, and the slider that opens the mold.
class ViewBar : public QToolBar {
    Q_OBJECT
public:
    ViewBar(const Actions& actions, QWidget* parent = nullptr);

    void setMode(DisplayMode mode);
    /// Whether there is anything to be shown in a mode.
    void setModesEnabled(bool enabled);
    void setMoldShown(bool shown);
    [[nodiscard]] double opening() const;
    /// Moves the slider there, as fast as a hand would.
    void easeOpening(double opening);

Q_SIGNALS:
    void modeChosen(moldwright::DisplayMode mode);
    void openingChanged(double opening);

private:
    void addTool(QAction* action);
    void addOpening();

    QComboBox* m_mode;
    QSlider* m_opening;
    QLabel* m_percent;
    QList<QAction*> m_moldParts;
};

} // namespace moldwright

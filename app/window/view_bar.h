// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/display_mode.h"

#include <QToolBar>

class QComboBox;

namespace moldwright {

class Actions;

/// The tool bar above the view: tools and display left, camera right.
class ViewBar : public QToolBar {
    Q_OBJECT
public:
    ViewBar(const Actions& actions, QWidget* parent = nullptr);

    void setMode(DisplayMode mode);
    /// Whether there is anything to be shown in a mode.
    void setModesEnabled(bool enabled);

Q_SIGNALS:
    void modeChosen(moldwright::DisplayMode mode);

private:
    void addTool(QAction* action);

    QComboBox* m_mode;
};

} // namespace moldwright

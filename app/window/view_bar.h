// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/presentation.h"

#include <QFrame>

class QAction;
class QComboBox;
class QHBoxLayout;
class QSlider;

namespace moldwright {

class Actions;

/// The tool bar above the view: tools and display left, camera right, and the slider that opens the mold.
class ViewBar : public QFrame {
    Q_OBJECT
public:
    ViewBar(const Actions& actions, QWidget* parent = nullptr);

    void setMode(DisplayMode mode);
    void setMoldShown(bool shown);
    [[nodiscard]] double opening() const;
    /// Moves the slider there, as fast as a hand would.
    void easeOpening(double opening);

Q_SIGNALS:
    void modeChosen(moldwright::DisplayMode mode);
    void openingChanged(double opening);

private:
    void addTool(QAction* action, QHBoxLayout* row);

    QComboBox* m_mode;
    QSlider* m_opening;
    QList<QWidget*> m_moldParts;
};

} // namespace moldwright

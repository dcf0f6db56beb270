// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QDockWidget>

namespace moldwright {

/// A dock with our 28 px title bar (float, close) and the panel's ground. `name` stays the same for stored
/// layouts; `title` is for people.
class Dock : public QDockWidget {
    Q_OBJECT
public:
    Dock(const QString& name, const QString& title, QWidget* content, QWidget* parent);

    /// Without its title: for docks whose tab says it.
    void setTitleShown(bool shown);

Q_SIGNALS:
    /// The user closed it.
    void closed();

private:
    QWidget* m_title;
    QWidget* m_noTitle;
};

} // namespace moldwright

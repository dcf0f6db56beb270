// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

class QKeySequenceEdit;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace moldwright {

class Actions;

/// All commands with their keys, to be changed: one types other keys for the command that is chosen. Keys
/// that another command has are named and not taken.
class KeyTable : public QWidget {
    Q_OBJECT
public:
    explicit KeyTable(Actions& actions, QWidget* parent = nullptr);

    /// Shows the commands that have all these words or keys; returns how many.
    int filter(const QString& typed);

private:
    QWidget* makeFoot();
    void fill();
    void choose();
    void take();
    [[nodiscard]] QString chosen() const;

    Actions& m_actions;
    QTreeWidget* m_list;
    QLabel* m_command;
    QKeySequenceEdit* m_keys;
    QPushButton* m_reset;
    QPushButton* m_resetAll;
    QLabel* m_conflict;
};

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <QListWidget>

#include <vector>

class QAction;

namespace moldwright {

/// Finds a command by its words and runs it. Lives in the corner of the menu bar; lists what fits as one
/// types.
class CommandSearch : public QLineEdit {
    Q_OBJECT
public:
    explicit CommandSearch(QWidget* parent = nullptr);
    void setCommands(std::vector<QAction*> commands) { m_commands = std::move(commands); }
    /// The command that leads here: its key is shown.
    void setOwnCommand(QAction* command);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void list();
    void run(QListWidgetItem* item);

    std::vector<QAction*> m_commands;
    QListWidget* m_list;
    QAction* m_own = nullptr;
};

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "theme/icons.h"

#include <QFrame>

#include <array>

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace moldwright {

/// A message above the view with what can be done about it: what happened, in bold, then where and what to
/// do.
class Banner : public QFrame {
    Q_OBJECT
public:
    explicit Banner(QWidget* parent = nullptr);

    /// Shows the message; `actions` (none, one or two) are its buttons, the foremost remedy first.
    void showMessage(Standing standing, const QString& headline, const QString& text,
                     const QStringList& actions = {});
    [[nodiscard]] QString headline() const;

Q_SIGNALS:
    /// By its place among the actions.
    void actionChosen(int action);
    /// Somebody closed the message.
    void closed();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Standing m_standing = Standing::Info;
    QLabel* m_icon;
    QLabel* m_headline;
    QLabel* m_text;
    std::array<QPushButton*, 2> m_actions;
};

} // namespace moldwright

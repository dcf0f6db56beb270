// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "theme/icons.h"

#include <QFrame>

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

    /// Shows the message; `action` (may be empty) is the remedy's button.
    void showMessage(Standing standing, const QString& headline, const QString& text,
                     const QString& action = {});
    [[nodiscard]] QString headline() const;

Q_SIGNALS:
    void actionChosen();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Standing m_standing = Standing::Info;
    QLabel* m_icon;
    QLabel* m_headline;
    QLabel* m_text;
    QPushButton* m_action;
};

} // namespace moldwright

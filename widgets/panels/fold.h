// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

class QToolButton;
class QVBoxLayout;

namespace moldwright {

/// A title that shows and hides what stands under it, by click or Space.
class Fold : public QWidget {
    Q_OBJECT
public:
    Fold(const QString& title, bool open, QWidget* parent = nullptr);

    /// Where to lay out what is hidden while it is folded.
    [[nodiscard]] QVBoxLayout* content() const { return m_content; }

Q_SIGNALS:
    void toggled(bool open);

private:
    void setOpen(bool open);

    QToolButton* m_title;
    QWidget* m_body;
    QVBoxLayout* m_content;
};

} // namespace moldwright

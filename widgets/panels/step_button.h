// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "theme/icons.h"

#include <QToolButton>

namespace moldwright {

/// One step of the job in the workflow bar: icon, name, and below it how it stands.
class StepButton : public QToolButton {
    Q_OBJECT
public:
    StepButton(const QString& iconName, const QString& name, QWidget* parent = nullptr);

    void setStanding(Standing standing, const QString& words);

    /// Narrow: the state's words go, its glyph moves onto the icon.
    void setNarrow(bool narrow);
    /// As wide as it would be with its state.
    [[nodiscard]] int wideWidth() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] int nameWidth() const;
    [[nodiscard]] QFont nameFont() const;
    [[nodiscard]] QFont stateFont() const;

    QString m_iconName;
    Standing m_standing = Standing::Todo;
    QString m_words;
    bool m_narrow = false;
};

} // namespace moldwright

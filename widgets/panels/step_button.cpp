// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/step_button.h"

#include "theme/theme.h"

#include <QPainter>
#include <QStyleOption>

namespace moldwright {

namespace {

constexpr int pictureSize = 24;
constexpr int iconLeft = 10;
constexpr int textLeft = 42;
constexpr int textRight = 12;
constexpr int glyph = 14;

} // namespace

StepButton::StepButton(const QString& iconName, const QString& name, QWidget* parent)
    : QToolButton(parent), m_iconName(iconName) {
    setText(name);
    setAccessibleName(name);
    setCheckable(true);
    setAutoRaise(true);
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
}

void StepButton::setStanding(Standing standing, const QString& words) {
    if (standing == m_standing && words == m_words)
        return;
    m_standing = standing;
    m_words = words;
    setAccessibleDescription(words);
    setToolTip(words.isEmpty() ? text() : QStringLiteral("%1: %2").arg(text(), words));
    updateGeometry();
    update();
}

void StepButton::setNarrow(bool narrow) {
    if (narrow == m_narrow)
        return;
    m_narrow = narrow;
    updateGeometry();
    update();
}

QFont StepButton::nameFont() const {
    QFont font = this->font();
    font.setPixelSize(13);
    font.setBold(isChecked() && isEnabled());
    return font;
}

QFont StepButton::stateFont() const {
    QFont font = this->font();
    font.setPixelSize(11);
    return font;
}

int StepButton::nameWidth() const {
    // The name's width is taken bold, so that choosing a step moves nothing.
    QFont bold = nameFont();
    bold.setBold(true);
    return textLeft + QFontMetrics(bold).horizontalAdvance(text()) + textRight;
}

int StepButton::wideWidth() const {
    const int words = m_words.isEmpty() ? 0 : QFontMetrics(stateFont()).horizontalAdvance(m_words);
    return std::max(nameWidth(), textLeft + glyph + 4 + words + textRight);
}

QSize StepButton::sizeHint() const {
    return {m_narrow || m_words.isEmpty() ? nameWidth() : wideWidth(), 58};
}

void StepButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme& t = theme();
    if (isChecked() && isEnabled()) {
        painter.fillRect(rect().adjusted(0, 4, 0, 0), t.accentSoft);
        painter.fillRect(0, height() - 3, width(), 3, t.palette.color(QPalette::Highlight));
    } else if (underMouse() && isEnabled()) {
        painter.fillRect(rect().adjusted(0, 4, 0, -3), t.palette.color(QPalette::Midlight));
    }
    const QIcon::Mode mode = isEnabled() ? QIcon::Normal : QIcon::Disabled;
    const QRect iconBox(iconLeft, (height() - pictureSize) / 2, pictureSize, pictureSize);
    themeIcon(m_iconName).paint(&painter, iconBox, Qt::AlignCenter, mode);

    const bool oneLine = m_narrow || m_words.isEmpty();
    painter.setPen(
        t.palette.color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText));
    painter.setFont(nameFont());
    const QRect nameBox(textLeft, oneLine ? 0 : 12, width() - textLeft, oneLine ? height() : 17);
    painter.drawText(nameBox, Qt::AlignLeft | Qt::AlignVCenter, text());
    if (!oneLine) {
        standingIcon(m_standing).paint(&painter, QRect(textLeft, 32, glyph, glyph));
        const bool coloured = m_standing == Standing::Stale || m_standing == Standing::Failing ||
                              m_standing == Standing::Warning;
        painter.setPen(coloured ? standingColour(m_standing) : t.palette.color(QPalette::PlaceholderText));
        painter.setFont(stateFont());
        painter.drawText(QRect(textLeft + glyph + 4, 31, width(), 16), Qt::AlignLeft | Qt::AlignVCenter,
                         m_words);
    } else if (!m_words.isEmpty() && isEnabled()) {
        standingIcon(m_standing).paint(&painter, QRect(iconLeft + 14, iconBox.bottom() - 8, 13, 13));
    }
    if (hasFocus()) {
        QStyleOptionFocusRect ring;
        ring.initFrom(this);
        style()->drawPrimitive(QStyle::PE_FrameFocusRect, &ring, &painter, this);
    }
}

} // namespace moldwright

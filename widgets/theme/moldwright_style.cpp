// SPDX-License-Identifier: AGPL-3.0-or-later
#include "theme/moldwright_style.h"

#include "theme/theme.h"

#include <QGuiApplication>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

namespace moldwright {

namespace {

constexpr int menuBarHeight = 28;

/// Fusion draws outlines as Window darkened by 140 %: give it the ground that yields our outline.
template <class Option>
Option withOutline(const Option& option) {
    Option copy = option;
    copy.palette.setColor(QPalette::Window, theme().outlineSeed);
    return copy;
}

void drawFocusRing(QPainter* painter, const QRect& around) {
    const Theme& t = theme();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(t.palette.color(t.dark ? QPalette::Link : QPalette::Highlight), 2));
    painter->setBrush(Qt::NoBrush);
    painter->drawRoundedRect(QRectF(around).adjusted(1, 1, -1, -1), 3, 3);
    painter->restore();
}

/// A tool that is on stands on the soft accent with an outline; one under the pointer on a little grey.
void drawToolGround(const QStyleOption* option, QPainter* painter) {
    const Theme& t = theme();
    const bool on = option->state.testFlag(QStyle::State_On);
    const bool hovered =
        option->state.testFlag(QStyle::State_MouseOver) && option->state.testFlag(QStyle::State_Enabled);
    if (!on && !hovered)
        return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(on ? t.palette.color(QPalette::Highlight) : t.palette.color(QPalette::Midlight));
    painter->setBrush(on ? t.accentSoft : t.palette.color(QPalette::Midlight));
    painter->drawRoundedRect(QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    painter->restore();
}

/// A screen's one filled button is named by a property.
bool isPrimary(const QWidget* widget) {
    return widget && widget->property("primary").toBool();
}

QFont bold(QFont font) {
    font.setBold(true);
    return font;
}

void drawPrimaryGround(const QStyleOption* option, QPainter* painter) {
    const QPalette& palette = theme().palette;
    const bool enabled = option->state.testFlag(QStyle::State_Enabled);
    const QColor accent = palette.color(QPalette::Highlight);
    const bool hovered = option->state.testFlag(QStyle::State_MouseOver);
    const bool focused = enabled && option->state.testFlag(QStyle::State_HasFocus);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(!enabled ? palette.color(QPalette::Midlight) : hovered ? accent.darker(112) : accent);
    painter->setPen(focused ? QPen(palette.color(QPalette::WindowText), 2) : QPen(Qt::NoPen));
    const double edge = focused ? 1 : 0;
    painter->drawRoundedRect(QRectF(option->rect).adjusted(edge, edge, -edge, -edge), 3, 3);
    painter->restore();
}

bool hasFocusRing(const QStyleOption* option) {
    return option->state.testFlag(QStyle::State_HasFocus) && option->state.testFlag(QStyle::State_Enabled);
}

} // namespace

MoldwrightStyle::MoldwrightStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void MoldwrightStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                    const QWidget* widget) const {
    switch (element) {
    case PE_FrameFocusRect:
        if (isPrimary(widget))
            return; // its ground has the ring
        drawFocusRing(painter, option->rect);
        return;
    case PE_FrameLineEdit:
    case PE_IndicatorCheckBox: {
        const QStyleOption outlined = withOutline(*option);
        QProxyStyle::drawPrimitive(element, &outlined, painter, widget);
        break;
    }
    case PE_PanelLineEdit: {
        if (const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option)) {
            const QStyleOptionFrame outlined = withOutline(*frame);
            QProxyStyle::drawPrimitive(element, &outlined, painter, widget);
            if (frame->lineWidth > 0 && hasFocusRing(option))
                drawFocusRing(painter, option->rect);
            return;
        }
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        break;
    }
    case PE_PanelButtonCommand: {
        if (isPrimary(widget)) {
            drawPrimaryGround(option, painter);
            return;
        }
        if (const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option)) {
            const QStyleOptionButton outlined = withOutline(*button);
            QProxyStyle::drawPrimitive(element, &outlined, painter, widget);
            return;
        }
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        break;
    }
    case PE_PanelButtonTool:
        drawToolGround(option, painter);
        break;
    case PE_IndicatorDockWidgetResizeHandle:
        painter->fillRect(option->rect, theme().palette.color(QPalette::Midlight));
        break;
    case PE_PanelToolBar:
    case PE_FrameStatusBarItem:
    case PE_PanelStatusBar:
        break; // bars are flat
    default:
        QProxyStyle::drawPrimitive(element, option, painter, widget);
    }
}

void MoldwrightStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                                  const QWidget* widget) const {
    switch (element) {
    case CE_ToolBar:
        painter->fillRect(option->rect, widget->palette().color(QPalette::Window));
        painter->fillRect(QRect(option->rect.left(), option->rect.bottom(), option->rect.width(), 1),
                          theme().palette.color(QPalette::Midlight));
        break;
    case CE_PushButtonLabel:
        if (const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
            button && isPrimary(widget)) {
            QStyleOptionButton label = *button;
            if (label.state.testFlag(State_Enabled))
                label.palette.setColor(QPalette::ButtonText, Qt::white);
            painter->setFont(bold(widget->font()));
            label.fontMetrics = painter->fontMetrics();
            QProxyStyle::drawControl(element, &label, painter, widget);
            return;
        }
        QProxyStyle::drawControl(element, option, painter, widget);
        break;
    case CE_MenuBarEmptyArea:
        painter->fillRect(option->rect, theme().palette.color(QPalette::Window));
        break;
    default:
        QProxyStyle::drawControl(element, option, painter, widget);
    }
}

int MoldwrightStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                               QStyleHintReturn* answer) const {
    // Mnemonics are underlined once Alt is held.
    if (hint == SH_UnderlineShortcut)
        return QGuiApplication::queryKeyboardModifiers().testFlag(Qt::AltModifier);
    return QProxyStyle::styleHint(hint, option, widget, answer);
}

QSize MoldwrightStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                                        const QWidget* widget) const {
    QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
    if (type == CT_MenuBarItem)
        size.setHeight(menuBarHeight);
    if (const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
        button && type == CT_PushButton && isPrimary(widget))
        size.rwidth() += QFontMetrics(bold(widget->font())).horizontalAdvance(button->text) -
                         option->fontMetrics.horizontalAdvance(button->text);
    return size;
}

void MoldwrightStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                         QPainter* painter, const QWidget* widget) const {
    if (const auto* spin = qstyleoption_cast<const QStyleOptionSpinBox*>(option)) {
        const QStyleOptionSpinBox outlined = withOutline(*spin);
        QProxyStyle::drawComplexControl(control, &outlined, painter, widget);
    } else if (const auto* combo = qstyleoption_cast<const QStyleOptionComboBox*>(option)) {
        const QStyleOptionComboBox outlined = withOutline(*combo);
        QProxyStyle::drawComplexControl(control, &outlined, painter, widget);
    } else if (const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
               slider && control == CC_Slider) {
        const QStyleOptionSlider outlined = withOutline(*slider);
        QProxyStyle::drawComplexControl(control, &outlined, painter, widget);
        return;
    } else {
        QProxyStyle::drawComplexControl(control, option, painter, widget);
        return;
    }
    if (hasFocusRing(option))
        drawFocusRing(painter, option->rect);
}

int MoldwrightStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                                 const QWidget* widget) const {
    switch (metric) {
    case PM_DockWidgetSeparatorExtent:
        return 1;
    case PM_ToolBarItemSpacing:
        return 4;
    case PM_ToolBarFrameWidth:
        return 0;
    case PM_ToolTipLabelFrameWidth:
        return 4;
    case PM_SmallIconSize:
        return 16;
    default:
        return QProxyStyle::pixelMetric(metric, option, widget);
    }
}

} // namespace moldwright

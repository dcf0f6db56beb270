// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace moldwright {

/// Fusion with outlines that can be seen on both themes (3:1 on the panel) and a focus ring of our own.
class MoldwrightStyle : public QProxyStyle {
    Q_OBJECT
public:
    MoldwrightStyle();

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* answer) const override;
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                           const QWidget* widget) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
};

} // namespace moldwright

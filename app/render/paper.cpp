// SPDX-License-Identifier: AGPL-3.0-or-later
#include "render/paper.h"

#include <QPageLayout>
#include <QPageSize>
#include <QPainterPath>

namespace moldwright::render {

namespace {

constexpr int dotsPerInch = 1200;
constexpr double millimetresPerInch = 25.4;
constexpr double pointsPerInch = 72;

} // namespace

Paper::Paper(const QString& file, const QString& title)
    : m_writer(file), m_unit(dotsPerInch / millimetresPerInch) {
    m_writer.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF()));
    m_writer.setResolution(dotsPerInch);
    m_writer.setTitle(title);
    m_writer.setCreator(QStringLiteral("Moldwright"));
    m_painter.begin(&m_writer);
    m_painter.setRenderHint(QPainter::SmoothPixmapTransform);
}

void Paper::newPage() {
    m_writer.newPage();
    ++m_pages;
}

QRectF Paper::device(const QRectF& area) const {
    return {area.x() * m_unit, area.y() * m_unit, area.width() * m_unit, area.height() * m_unit};
}

void Paper::setPen(double points, QColor colour, Qt::PenStyle style) {
    QPen pen(colour, points * dotsPerInch / pointsPerInch, style);
    pen.setCapStyle(Qt::FlatCap);
    m_painter.setPen(pen);
}

void Paper::setFont(const Type& type) {
    QFont font(QStringLiteral("Noto Sans"));
    font.setPointSizeF(type.points);
    font.setBold(type.bold);
    m_painter.setFont(font);
}

double Paper::widthOf(const QString& words, const Type& type) {
    setFont(type);
    return m_painter.boundingRect(QRectF(), Qt::AlignLeft, words).width() / m_unit;
}

double Paper::text(double x, double y, double w, const QString& words, const Type& type,
                   Qt::AlignmentFlag side) {
    setFont(type);
    m_painter.setPen(type.colour);
    QRectF used;
    // Room downwards without end: what is set decides its height.
    const QRectF room = device({x, y, w, height});
    m_painter.drawText(room, static_cast<int>(side) | Qt::AlignTop | Qt::TextWordWrap, words, &used);
    return used.height() / m_unit;
}

void Paper::line(double x1, double y1, double x2, double y2, double points, QColor colour) {
    setPen(points, colour);
    m_painter.drawLine(QPointF(x1, y1) * m_unit, QPointF(x2, y2) * m_unit);
}

void Paper::dashedLine(double x1, double y1, double x2, double y2, double points, QColor colour) {
    setPen(points, colour, Qt::DashLine);
    m_painter.drawLine(QPointF(x1, y1) * m_unit, QPointF(x2, y2) * m_unit);
}

void Paper::fill(const QRectF& area, QColor colour) {
    m_painter.fillRect(device(area), colour);
}

void Paper::picture(const QRectF& area, const QImage& image) {
    const QRectF room = device(area);
    QRectF target(QPointF(), QSizeF(image.size()).scaled(room.size(), Qt::KeepAspectRatio));
    target.moveCenter(room.center());
    m_painter.drawImage(target, image);
}

void Paper::mark(double x, double y, double diameter, bool holds) {
    const QColor colour = holds ? ink::green : ink::red;
    const double stroke = diameter * 0.08 * pointsPerInch / millimetresPerInch;
    m_painter.save();
    setPen(stroke, colour);
    if (holds)
        m_painter.setBrush(ink::greenSoft);
    m_painter.drawEllipse(device({x, y, diameter, diameter}));
    const auto at = [&](double fx, double fy) {
        return QPointF(x + fx * diameter, y + fy * diameter) * m_unit;
    };
    m_painter.setBrush(Qt::NoBrush);
    QPainterPath sign;
    if (holds) {
        sign.moveTo(at(0.29, 0.52));
        sign.lineTo(at(0.44, 0.67));
        sign.lineTo(at(0.72, 0.36));
    } else {
        sign.moveTo(at(0.34, 0.34));
        sign.lineTo(at(0.66, 0.66));
        sign.moveTo(at(0.66, 0.34));
        sign.lineTo(at(0.34, 0.66));
    }
    m_painter.drawPath(sign);
    m_painter.restore();
}

} // namespace moldwright::render

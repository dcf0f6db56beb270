// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QRectF>
#include <QString>

namespace moldwright::render {

/// The colours of a printed report.
namespace ink {
constexpr QColor text{0x1a, 0x1f, 0x26};
constexpr QColor secondary{0x54, 0x5e, 0x6b};
constexpr QColor hairline{0xcd, 0xd3, 0xda};
constexpr QColor red{0xc2, 0x23, 0x1a};
constexpr QColor green{0x1b, 0x73, 0x40};
constexpr QColor greenSoft{0xdd, 0xf1, 0xe4};
constexpr QColor amber{0x8a, 0x53, 0x00};
constexpr QColor side1{0x0a, 0x5f, 0x78};
constexpr QColor side2{0xb9, 0x7a, 0x0c};
} // namespace ink

/// How a piece of text is set. Sizes in a report: 7.5 caption, 9 body, 10 heading, 19 verdict.
struct Type {
    double points = 9;
    bool bold = false;
    QColor colour = ink::text;
};

/// A4 pages of a PDF, measured in mm from the upper left corner of the page.
class Paper {
public:
    static constexpr double width = 210;
    static constexpr double height = 297;
    static constexpr double left = 15;   ///< margin
    static constexpr double right = 195; ///< where the right margin begins

    Paper(const QString& file, const QString& title);

    [[nodiscard]] bool open() const { return m_painter.isActive(); }
    void newPage();
    [[nodiscard]] int pages() const { return m_pages; }
    /// Ends the file; false when it could not be written.
    [[nodiscard]] bool close() { return m_painter.end(); }

    /// Sets text from the top edge y within [x, x + w], broken at spaces and line ends; returns its height.
    double text(double x, double y, double w, const QString& words, const Type& type,
                Qt::AlignmentFlag side = Qt::AlignLeft);
    [[nodiscard]] double widthOf(const QString& words, const Type& type);
    void line(double x1, double y1, double x2, double y2, double points, QColor colour);
    void fill(const QRectF& area, QColor colour);
    void dashedLine(double x1, double y1, double x2, double y2, double points, QColor colour);
    /// The picture as large as fits into the area, in its middle.
    void picture(const QRectF& area, const QImage& image);
    /// A tick or a cross in a circle of this diameter.
    void mark(double x, double y, double diameter, bool holds);

private:
    [[nodiscard]] QRectF device(const QRectF& area) const;
    void setFont(const Type& type);
    void setPen(double points, QColor colour, Qt::PenStyle style = Qt::SolidLine);

    QPdfWriter m_writer;
    QPainter m_painter;
    double m_unit; ///< device units per mm
    int m_pages = 1;
};

} // namespace moldwright::render

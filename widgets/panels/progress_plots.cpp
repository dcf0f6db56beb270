// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/progress_plots.h"

#include "theme/theme.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <optional>

namespace moldwright {

namespace {

constexpr int axisWidth = 46;
constexpr int headHeight = 28;
constexpr int footHeight = 20;

QString signedNumber(double value, int decimals) {
    return QString::number(value, 'f', decimals).replace(u'-', QChar(0x2212));
}

QString powerOfTen(long exponent) {
    QString power = QString::number(exponent);
    const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    for (int digit = 0; digit < 10; ++digit)
        power.replace(QChar(u'0' + digit), digits[digit]);
    return QStringLiteral("10") + power.replace(u'-', u'⁻');
}

/// A step of 1, 2 or 5 times a power of ten that cuts `span` into about `parts`.
double niceStep(double span, int parts) {
    const double raw = std::max(span / parts, 1e-12);
    const double power = std::pow(10, std::floor(std::log10(raw)));
    for (const double nice : {1., 2., 5.})
        if (raw <= nice * power * 1.0001)
            return nice * power;
    return 10 * power;
}

} // namespace

QString scientificText(double value) {
    const QStringList parts = QString::number(value, 'e', 1).split(u'e');
    return value == 0 ? QStringLiteral("0") : parts[0] + u'·' + powerOfTen(parts[1].toLong());
}

struct ProgressPlots::Plot {
    QString title;
    QString now;
    bool logarithmic = false;
    std::optional<double> goal;
    std::vector<double> values;
    QString suffix;

    [[nodiscard]] double height(double value) const {
        return logarithmic ? std::log10(std::max(value, 1e-7)) : value;
    }
    [[nodiscard]] QString label(double height) const {
        if (!logarithmic)
            return signedNumber(height, std::abs(height - std::round(height)) > 0.01 ? 1 : 0) + suffix;
        return powerOfTen(std::lround(height));
    }
};

ProgressPlots::ProgressPlots(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Energy, worst draft and violating area over the steps"));
    setBackgroundRole(QPalette::Base);
    setAutoFillBackground(true);
}

void ProgressPlots::clear() {
    m_points.clear();
    update();
}

void ProgressPlots::add(const ProgressPoint& point) {
    m_points.push_back(point);
    update();
}

void ProgressPlots::setRequiredDraft(double degrees) {
    m_requiredDraft = degrees;
    update();
}

void ProgressPlots::setMarked(int step) {
    m_marked = step;
    update();
}

const ProgressPoint& ProgressPlots::told() const {
    const auto marked = std::ranges::find(m_points, m_marked, &ProgressPoint::step);
    return marked == m_points.end() ? m_points.back() : *marked;
}

std::vector<ProgressPlots::Plot> ProgressPlots::plots() const {
    const ProgressPoint& last = told();
    std::vector<Plot> all(3);
    all[0] = {tr("Energy"), scientificText(last.energy), true, std::nullopt, {}, {}};
    all[1] = {tr("Worst draft"),
              signedNumber(std::floor(last.worstDraftDegrees * 10) / 10, 1) + QStringLiteral("°"),
              false,
              m_requiredDraft,
              {},
              QStringLiteral("°")};
    all[2] = {tr("Area below %1°").arg(m_requiredDraft, 0, 'f', 1),
              QStringLiteral("%1 %").arg(100 * last.violatingAreaFraction, 0, 'f', 1),
              false,
              0,
              {},
              QStringLiteral(" %")};
    for (const ProgressPoint& point : m_points) {
        all[0].values.push_back(point.energy);
        all[1].values.push_back(point.worstDraftDegrees);
        all[2].values.push_back(100 * point.violatingAreaFraction);
    }
    return all;
}

void ProgressPlots::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_points.empty()) {
        painter.setPen(theme().palette.color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(12, 10, -12, -10), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                         tr("A run draws energy, worst draft and area here, step by step."));
        return;
    }
    const std::vector<Plot> all = plots();
    const int each = width() / 3;
    for (int i = 0; i < 3; ++i)
        paintPlot(painter, all[i], QRect(i * each, 0, each, height()));
}

void ProgressPlots::paintPlot(QPainter& painter, const Plot& plot, const QRect& box) const {
    const QPalette& palette = theme().palette;
    QFont font = this->font();
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(palette.color(QPalette::Text));
    const QRect head(box.left() + 10, box.top(), box.width() - 22, headHeight);
    const int room = head.width() - painter.fontMetrics().horizontalAdvance(plot.now) - 8;
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(plot.title, Qt::ElideRight, room));
    painter.setPen(palette.color(QPalette::Link));
    painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, plot.now);
    font.setBold(false);
    font.setPixelSize(11);
    painter.setFont(font);

    const QRectF field(box.left() + axisWidth, box.top() + headHeight + 6, box.width() - axisWidth - 14,
                       box.height() - headHeight - footHeight - 8);
    double low = plot.goal ? plot.height(*plot.goal) : plot.height(plot.values.front());
    double high = low;
    for (const double value : plot.values) {
        low = std::min(low, plot.height(value));
        high = std::max(high, plot.height(value));
    }
    const double step =
        plot.logarithmic ? std::max(1.0, std::ceil((high - low) / 4)) : niceStep(high - low, 3);
    low = std::floor(low / step) * step;
    high = std::max(std::ceil(high / step) * step, low + step);
    const auto yOf = [&](double h) { return field.bottom() - (h - low) / (high - low) * field.height(); };
    const double lastStep = std::max(1.0, static_cast<double>(m_points.size() - 1));
    const auto xOf = [&](std::size_t i) {
        return field.left() + field.width() * static_cast<double>(i) / lastStep;
    };

    for (double h = low; h <= high + step / 2; h += step) {
        painter.setPen(palette.color(QPalette::Midlight));
        painter.drawLine(QPointF(field.left(), yOf(h)), QPointF(field.right(), yOf(h)));
        painter.setPen(palette.color(QPalette::PlaceholderText));
        painter.drawText(QRectF(box.left(), yOf(h) - 8, axisWidth - 6, 16), Qt::AlignRight | Qt::AlignVCenter,
                         plot.label(h));
    }
    painter.setPen(palette.color(QPalette::PlaceholderText));
    const QRectF foot(field.left() - 20, field.bottom() + 4, field.width() + 30, 14);
    painter.drawText(foot.adjusted(16, 0, 0, 0), Qt::AlignLeft, QString::number(m_points.front().step));
    painter.drawText(foot, Qt::AlignRight, QString::number(m_points.back().step));
    if (plot.goal) {
        painter.setPen(QPen(theme().done, 1.4, Qt::DashLine));
        painter.drawLine(QPointF(field.left(), yOf(*plot.goal)), QPointF(field.right(), yOf(*plot.goal)));
    }
    QPolygonF line;
    for (std::size_t i = 0; i < plot.values.size(); ++i)
        line << QPointF(xOf(i), yOf(plot.height(plot.values[i])));
    painter.setPen(QPen(palette.color(QPalette::Link), 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.setBrush(palette.color(QPalette::Link));
    painter.setPen(Qt::NoPen);
    const auto at = static_cast<qsizetype>(&told() - m_points.data());
    painter.drawEllipse(line[at], 3, 3);
    if (m_marked > 0) {
        painter.setPen(QPen(palette.color(QPalette::Link), 1));
        painter.drawLine(QPointF(line[at].x(), field.top()), QPointF(line[at].x(), field.bottom()));
    }
    painter.setBrush(Qt::NoBrush);
}

} // namespace moldwright

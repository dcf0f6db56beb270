// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/measurement.h"

#include "castability/mold_state.h"
#include "window/presentation.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t mostPoints = 3;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Measurement)
};

QString number(double value) {
    return QString::number(value, 'f', 2).replace(u'-', QChar(0x2212));
}

QString lengthText(double mm) {
    return number(mm) + u" mm"_s;
}

QString placeText(const Eigen::Vector3d& p) {
    return u"%1  %2  %3 mm"_s.arg(number(p.x()), number(p.y()), number(p.z()));
}

scene::PanelContent::Line line(const QString& name, const QString& value) {
    return {std::nullopt, {{name.toStdString(), scene::Ink::Secondary}, {value.toStdString()}}, {}};
}

} // namespace

QString surfaceText(const MeasuredPoint& point) {
    QStringList parts;
    if (point.draftDegrees)
        parts << Words::tr("Draft %1").arg(angleText(*point.draftDegrees));
    if (point.thickness)
        parts << Words::tr("thickness %1").arg(lengthText(*point.thickness));
    if (point.mapValue)
        parts << *point.mapValue;
    return parts.isEmpty() ? Words::tr("On the section") : parts.join(u", "_s);
}

void Measurement::add(const SharedMesh& surface, const MeasuredPoint& point) {
    if (surface != m_surface || m_points.size() == mostPoints)
        m_points.clear();
    m_surface = surface;
    m_points.push_back(point);
}

std::vector<Eigen::Vector3d> Measurement::path() const {
    std::vector<Eigen::Vector3d> places;
    std::ranges::transform(m_points, std::back_inserter(places), &MeasuredPoint::place);
    return places;
}

std::optional<double> Measurement::distance() const {
    if (m_points.size() < 2)
        return std::nullopt;
    return (m_points[1].place - m_points[0].place).norm();
}

std::optional<double> Measurement::angleDegrees() const {
    if (m_points.size() < 3)
        return std::nullopt;
    const Eigen::Vector3d a = m_points[0].place - m_points[1].place;
    const Eigen::Vector3d b = m_points[2].place - m_points[1].place;
    return degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
}

std::vector<scene::Chip> Measurement::chips(scene::Rgb mark) const {
    std::vector<scene::Chip> chips;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const MeasuredPoint& point = m_points[i];
        scene::PanelContent content;
        content.lines = {line(Words::tr("Point %1").arg(i + 1), placeText(point.place)),
                         line({}, surfaceText(point))};
        content.lines.back().runs.erase(content.lines.back().runs.begin());
        chips.push_back({point.place, content, mark});
    }
    const auto between = [&](const Eigen::Vector3d& place, const QString& words, const QString& value) {
        chips.push_back(
            {place, {{}, {{std::nullopt, {{words.toStdString()}, {value.toStdString(), {}, true}}, {}}}}});
    };
    if (const auto way = distance())
        between((m_points[0].place + m_points[1].place) / 2, Words::tr("Distance"), lengthText(*way));
    if (const auto angle = angleDegrees())
        between((m_points[1].place + m_points[2].place) / 2, Words::tr("Angle"), angleText(*angle));
    return chips;
}

QString Measurement::text() const {
    QStringList lines;
    for (std::size_t i = 0; i < m_points.size(); ++i)
        lines << Words::tr("Point %1").arg(i + 1) + u": "_s + placeText(m_points[i].place) + u"; "_s +
                     surfaceText(m_points[i]);
    if (const auto way = distance()) {
        const Eigen::Vector3d d = m_points[1].place - m_points[0].place;
        lines << Words::tr("Distance") + u": "_s + lengthText(*way) +
                     u" (x %1, y %2, z %3)"_s.arg(number(d.x()), number(d.y()), number(d.z()));
    }
    if (const auto angle = angleDegrees())
        lines << Words::tr("Angle") + u": "_s + angleText(*angle);
    return lines.join(u'\n');
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/measure_tool.h"

#include "view/part_view.h"
#include "window/face_paint.h"
#include "window/view_pane.h"
#include "window/workbench.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>

#include <algorithm>

namespace moldwright {

MeasureTool::MeasureTool(Workbench& bench, QObject* parent) : QObject(parent), m_bench(bench) {}

void MeasureTool::setActive(bool active) {
    m_active = active;
    m_measurement.clear();
    delete m_reading;
    Q_EMIT changed();
}

void MeasureTool::serve(ViewPane& pane) {
    connect(&pane.view(), &PartView::pointClicked, this,
            [this, &pane](const scene::SurfacePicker::Hit& hit) { take(pane, hit); });
    connect(&pane.view(), &PartView::pointHovered, this,
            [this, &pane](const std::optional<scene::SurfacePicker::Hit>& hit) { hover(pane, hit); });
}

std::optional<MeasuredPoint> MeasureTool::pointAt(const ViewPane& pane,
                                                  const scene::SurfacePicker::Hit& hit) {
    const ViewSettings& settings = pane.settings();
    const ShownSurface surface = m_bench.surface(settings.content);
    // While a run shows other shapes, the places are those of a surface that is gone.
    if (!surface.picker || surface.picker->mesh() != surface.drawn->mesh)
        return std::nullopt;
    MeasuredPoint point{.place = hit.point};
    if (hit.face < 0)
        return point;
    const auto face = static_cast<std::size_t>(hit.face);
    if (surface.analysis && !surface.coarse)
        point.draftDegrees = surface.analysis->faceDraft[face];
    point.thickness = surface.picker->thickness(hit);
    if (const FaceMap* map = m_bench.map(settings.content, settings.mode))
        point.mapValue = mapValueText(*map, map->values[face]);
    return point;
}

void MeasureTool::take(const ViewPane& pane, const scene::SurfacePicker::Hit& hit) {
    const std::optional<MeasuredPoint> point = m_active ? pointAt(pane, hit) : std::nullopt;
    if (!point)
        return;
    m_measurement.add(m_bench.surface(pane.settings().content).drawn->mesh, *point);
    if (m_reading)
        m_reading->hide();
    Q_EMIT changed();
}

void MeasureTool::hover(ViewPane& pane, const std::optional<scene::SurfacePicker::Hit>& hit) {
    const std::optional<MeasuredPoint> point = hit && m_active ? pointAt(pane, *hit) : std::nullopt;
    if (!point) {
        if (m_reading)
            m_reading->hide();
        return;
    }
    PartView& view = pane.view();
    if (!m_reading || m_reading->parent() != &view) {
        delete m_reading;
        m_reading = new QLabel(&view);
        m_reading->setObjectName(QStringLiteral("reading"));
        m_reading->setAutoFillBackground(true);
        m_reading->setForegroundRole(QPalette::ToolTipText);
        m_reading->setBackgroundRole(QPalette::ToolTipBase);
        m_reading->setMargin(4);
        m_reading->setAttribute(Qt::WA_TransparentForMouseEvents);
    }
    m_reading->setText(surfaceText(*point));
    m_reading->adjustSize();
    const QPoint beside = view.pixelOf(point->place) + QPoint(16, 16);
    m_reading->move(std::clamp(beside.x(), 0, std::max(0, view.width() - m_reading->width())),
                    std::clamp(beside.y(), 0, std::max(0, view.height() - m_reading->height())));
    m_reading->show();
}

void MeasureTool::copy() const {
    QGuiApplication::clipboard()->setText(m_measurement.text());
}

} // namespace moldwright

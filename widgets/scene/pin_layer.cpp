// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/pin_layer.h"

#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkPoints.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace moldwright::scene {

namespace {

constexpr int dashes = 14; ///< on each line: the graphics have none of their own

DiscLook pinLook(const SceneColours& colours, bool chosen, double scale) {
    DiscLook look{7.5 * scale, 1.5 * scale, colours.pin};
    if (chosen) {
        look.radius = 9.5 * scale;
        look.rim = 2.5 * scale;
        look.edge = colours.accent;
    }
    return look;
}

DiscLook ringLook(Rgb colour, double radius, double rim, double opacity) {
    return {radius, rim, colour, colour, 0, opacity};
}

} // namespace

PinLayer::PinLayer() {
    const vtkNew<vtkCoordinate> inTheScene;
    inTheScene->SetCoordinateSystemToWorld();
    m_mapper->SetInputData(m_dashes);
    m_mapper->SetTransformCoordinate(inTheScene);
    m_lines->SetMapper(m_mapper);
}

void PinLayer::addTo(vtkRenderer* renderer) {
    m_renderer = renderer;
    renderer->AddViewProp(m_lines);
}

void PinLayer::setLook(const SceneColours& colours, double scale) {
    m_colours = colours;
    m_scale = scale;
    m_lines->GetProperty()->SetColor(colours.pinLine.unit().data());
    m_lines->GetProperty()->SetLineWidth(static_cast<float>(1.6 * scale));
    show();
}

void PinLayer::set(const ShownPins& pins) {
    if (pins == m_pins)
        return;
    m_pins = pins;
    show();
    layLines();
}

void PinLayer::showDiscs(Discs& discs, const std::vector<DiscLook>& looks) {
    while (discs.size() < looks.size())
        discs.push_back(std::make_unique<GripDisc>(m_renderer));
    for (std::size_t i = 0; i < discs.size(); ++i)
        discs[i]->show(i < looks.size(), i < looks.size() ? looks[i] : DiscLook{});
}

void PinLayer::show() {
    showDiscs(m_suggested,
              std::vector<DiscLook>(m_pins.suggested.size(),
                                    ringLook(m_colours.pinLine, 5 * m_scale, 1.6 * m_scale, 0.6)));
    std::vector<DiscLook> rings;
    std::vector<DiscLook> discs;
    for (const ShownPin& pin : m_pins.pins) {
        discs.push_back(pinLook(m_colours, pin.chosen, m_scale));
        if (pin.onPlane)
            rings.push_back(ringLook(m_colours.pinLine, 5.5 * m_scale, 2 * m_scale, 1));
    }
    showDiscs(m_rings, rings);
    showDiscs(m_discs, discs);
}

void PinLayer::layLines() {
    m_dashes->Initialize();
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    const vtkNew<vtkCellArray> lines;
    for (const ShownPin& pin : m_pins.pins) {
        if (!pin.onPlane)
            continue;
        const Eigen::Vector3d way = (*pin.onPlane - pin.place) / (2 * dashes);
        for (int k = 0; k < dashes; ++k) {
            lines->InsertNextCell(2);
            for (const int end : {2 * k, 2 * k + 1})
                lines->InsertCellPoint(
                    points->InsertNextPoint(Eigen::Vector3d(pin.place + end * way).data()));
        }
    }
    m_dashes->SetPoints(points);
    m_dashes->SetLines(lines);
}

std::optional<PinAt> PinLayer::at(const Camera& camera, ViewSize view, double x, double y,
                                  double reach) const {
    const auto away = [&](const Eigen::Vector3d& place) {
        return (camera.project(place, view).head<2>() - Eigen::Vector2d(x, y)).norm();
    };
    std::optional<PinAt> nearest;
    double least = reach;
    for (std::size_t i = 0; i < m_pins.pins.size(); ++i)
        if (const double distance = away(m_pins.pins[i].place); distance <= least) {
            least = distance;
            nearest = PinAt{false, m_pins.pins[i].number};
        }
    for (std::size_t i = 0; i < m_pins.suggested.size() && (!nearest || nearest->suggested); ++i)
        if (const double distance = away(m_pins.suggested[i]); distance <= least) {
            least = distance;
            nearest = PinAt{true, static_cast<int>(i)};
        }
    return nearest;
}

void PinLayer::arrange(const Camera& camera, ViewSize view) {
    const auto move = [&](GripDisc& disc, const Eigen::Vector3d& place) {
        const Eigen::Vector3d pixel = camera.project(place, view);
        disc.moveTo(pixel.x(), view.height - pixel.y());
    };
    for (std::size_t i = 0; i < m_pins.suggested.size(); ++i)
        move(*m_suggested[i], m_pins.suggested[i]);
    std::size_t ring = 0;
    for (std::size_t i = 0; i < m_pins.pins.size(); ++i) {
        move(*m_discs[i], m_pins.pins[i].place);
        if (m_pins.pins[i].onPlane)
            move(*m_rings[ring++], *m_pins.pins[i].onPlane);
    }
}

} // namespace moldwright::scene

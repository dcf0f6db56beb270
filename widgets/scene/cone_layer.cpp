// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/cone_layer.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include <cmath>
#include <numbers>

namespace moldwright::scene {

namespace {

constexpr int corners = 72; ///< of the circle
constexpr double collarOpacity = 0.2;

} // namespace

ConeLayer::ConeLayer() {
    m_collarMapper->SetInputData(m_collar);
    m_rimMapper->SetInputData(m_rim);
    m_collarActor->SetMapper(m_collarMapper);
    m_rimActor->SetMapper(m_rimMapper);
    for (vtkActor* actor : {m_collarActor.Get(), m_rimActor.Get()}) {
        actor->GetProperty()->LightingOff();
        actor->PickableOff();
    }
    m_collarActor->GetProperty()->SetOpacity(collarOpacity);
}

void ConeLayer::set(const DirectionCap& cap, const Eigen::Vector3d& middle, double near, double far) {
    const auto [u, v] = planeAxes(cap.middle);
    const double angle = radians(cap.radiusDegrees);
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    const vtkNew<vtkCellArray> collar;
    const vtkNew<vtkCellArray> rim;
    rim->InsertNextCell(corners + 1);
    for (int k = 0; k <= corners; ++k) {
        const double way = 2 * std::numbers::pi * (k % corners) / corners;
        const Eigen::Vector3d direction =
            std::cos(angle) * cap.middle + std::sin(angle) * (std::cos(way) * u + std::sin(way) * v);
        points->InsertNextPoint(Eigen::Vector3d(middle + near * direction).data());
        rim->InsertCellPoint(points->InsertNextPoint(Eigen::Vector3d(middle + far * direction).data()));
        if (k > 0)
            collar->InsertNextCell({2 * k - 2, 2 * k - 1, 2 * k + 1, 2 * k});
    }
    m_collar->SetPoints(points);
    m_collar->SetPolys(collar);
    m_rim->SetPoints(points);
    m_rim->SetLines(rim);
}

void ConeLayer::setLook(Rgb colour, double scale) {
    m_collarActor->GetProperty()->SetColor(colour.unit().data());
    m_rimActor->GetProperty()->SetColor(colour.unit().data());
    m_rimActor->GetProperty()->SetLineWidth(static_cast<float>(1.6 * scale));
}

} // namespace moldwright::scene

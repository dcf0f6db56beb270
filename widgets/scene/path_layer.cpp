// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/path_layer.h"

#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkPoints.h>
#include <vtkProperty2D.h>

namespace moldwright::scene {

PathLayer::PathLayer() {
    const vtkNew<vtkCoordinate> inTheScene;
    inTheScene->SetCoordinateSystemToWorld();
    m_mapper->SetInputData(m_line);
    m_mapper->SetTransformCoordinate(inTheScene);
    m_actor->SetMapper(m_mapper);
}

void PathLayer::set(const std::vector<Eigen::Vector3d>& places) {
    m_line->Initialize();
    if (places.size() < 2)
        return;
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    const vtkNew<vtkCellArray> line;
    line->InsertNextCell(static_cast<int>(places.size()));
    for (const Eigen::Vector3d& place : places)
        line->InsertCellPoint(points->InsertNextPoint(place.data()));
    m_line->SetPoints(points);
    m_line->SetLines(line);
}

void PathLayer::setLook(Rgb colour, double lineWidth) {
    m_actor->GetProperty()->SetColor(colour.unit().data());
    m_actor->GetProperty()->SetLineWidth(static_cast<float>(lineWidth));
}

} // namespace moldwright::scene

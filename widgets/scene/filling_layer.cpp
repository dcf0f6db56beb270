// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/filling_layer.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

namespace moldwright::scene {

namespace {

constexpr double opacity = 0.38;

} // namespace

FillingLayer::FillingLayer() {
    m_mapper->SetInputData(m_data);
    m_actor->SetMapper(m_mapper);
    m_actor->GetProperty()->SetOpacity(opacity);
    m_actor->GetProperty()->SetAmbient(0.45);
    m_actor->GetProperty()->BackfaceCullingOn(); // one layer of glass where walls lie behind one another
    m_actor->PickableOff();
    m_actor->VisibilityOff();
}

void FillingLayer::set(const SharedMesh& walls) {
    if (walls == m_walls)
        return;
    m_walls = walls;
    m_actor->SetVisibility(walls != nullptr);
    m_data->Initialize();
    if (!walls)
        return;
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(walls->V.rows());
    for (int v = 0; v < walls->vertexCount(); ++v)
        points->SetPoint(v, walls->V.row(v).data());
    const vtkNew<vtkCellArray> faces;
    for (int f = 0; f < walls->faceCount(); ++f)
        faces->InsertNextCell({walls->F(f, 0), walls->F(f, 1), walls->F(f, 2)});
    m_data->SetPoints(points);
    m_data->SetPolys(faces);
}

void FillingLayer::setColour(Rgb colour) {
    m_actor->GetProperty()->SetColor(colour.unit().data());
}

} // namespace moldwright::scene

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/fault_layer.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

namespace moldwright::scene {

FaultLayer::FaultLayer() {
    m_mapper->SetInputData(m_lines);
    // They lie in the surface: they are drawn a little nearer than the faces they border.
    m_mapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -8);
    m_actor->SetMapper(m_mapper);
    m_actor->GetProperty()->LightingOff();
    m_actor->PickableOff();
    m_actor->VisibilityOff();
}

void FaultLayer::set(const std::vector<Edge>& edges) {
    if (edges.empty() && edgeCount() == 0)
        return;
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    const vtkNew<vtkCellArray> lines;
    for (const Edge& edge : edges) {
        const vtkIdType from = points->InsertNextPoint(edge[0].data());
        const vtkIdType to = points->InsertNextPoint(edge[1].data());
        lines->InsertNextCell({from, to});
    }
    m_lines->SetPoints(points);
    m_lines->SetLines(lines);
    m_actor->SetVisibility(!edges.empty());
}

void FaultLayer::setLook(Rgb colour, double lineWidth) {
    m_actor->GetProperty()->SetColor(colour.unit().data());
    m_actor->GetProperty()->SetLineWidth(static_cast<float>(lineWidth));
}

} // namespace moldwright::scene

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/plane_layer.h"

#include "scene/parting_line.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include <array>

namespace moldwright::scene {

namespace {

void prepareFlat(vtkPolyData* data, vtkPolyDataMapper* mapper, vtkActor* actor) {
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
}

} // namespace

PlaneLayer::PlaneLayer() {
    prepareFlat(m_sheet, m_sheetMapper, m_sheetActor);
    prepareFlat(m_outline, m_outlineMapper, m_outlineActor);
    prepareFlat(m_line, m_lineMapper, m_lineActor);
    // The parting line lies in the surface: it is drawn a little nearer than the faces it borders.
    m_lineMapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_lineMapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -8);
}

void PlaneLayer::setPlane(const PlaneRectangle& rectangle) {
    vtkNew<vtkPoints> corners;
    constexpr std::array<std::array<double, 2>, 4> around = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (const auto& [s, t] : around)
        corners->InsertNextPoint(rectangle.at(s, t).data());
    vtkNew<vtkCellArray> sheet;
    sheet->InsertNextCell({0, 1, 2, 3});
    m_sheet->SetPoints(corners);
    m_sheet->SetPolys(sheet);
    vtkNew<vtkCellArray> outline;
    outline->InsertNextCell({0, 1, 2, 3, 0});
    m_outline->SetPoints(corners);
    m_outline->SetLines(outline);
}

void PlaneLayer::setPartingLine(const IndexedMesh& mesh, const PartingPlane& plane) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> lines;
    for (const auto& [from, to] : partingSegments(mesh, plane)) {
        const vtkIdType first = points->InsertNextPoint(from.data());
        lines->InsertNextCell({first, points->InsertNextPoint(to.data())});
    }
    m_line->SetPoints(points);
    m_line->SetLines(lines);
}

void PlaneLayer::clearPartingLine() {
    m_line->Initialize();
}

void PlaneLayer::setColours(const SceneColours& colours, double scale) {
    m_sheetActor->GetProperty()->SetColor(colours.plane.unit().data());
    m_sheetActor->GetProperty()->SetOpacity(colours.planeOpacity);
    m_outlineActor->GetProperty()->SetColor(colours.plane.unit().data());
    m_outlineActor->GetProperty()->SetLineWidth(static_cast<float>(1.6 * scale));
    m_lineActor->GetProperty()->SetColor(colours.partingLine.unit().data());
    m_lineActor->GetProperty()->SetLineWidth(static_cast<float>(1.7 * scale));
}

} // namespace moldwright::scene

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/plane_layer.h"

#include "castability/crease.h"
#include "scene/parting_line.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace moldwright::scene {

namespace {

constexpr double leastCrease = 1;    ///< degrees that are drawn
constexpr double densestCrease = 25; ///< degrees at which the band is opaque

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
    prepareFlat(m_crease, m_creaseMapper, m_creaseActor);
    m_creaseMapper->ScalarVisibilityOn();
    m_creaseMapper->SetColorModeToDirectScalars();
    m_creaseMapper->SetScalarModeToUseCellData();
    m_creaseMapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_creaseMapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -6);
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

void PlaneLayer::setPartingLine(const IndexedMesh& mesh, const MoldState& state) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkCellArray> creased;
    vtkNew<vtkUnsignedCharArray> bands;
    bands->SetNumberOfComponents(4);
    m_sharpest = {};
    for (const auto& [from, to] : partingSegments(mesh, state.plane)) {
        const vtkIdType first = points->InsertNextPoint(from.data());
        const vtkIdType last = points->InsertNextPoint(to.data());
        lines->InsertNextCell({first, last});
        const double sharpness = creaseDegrees(state, to - from);
        if (sharpness > m_sharpest.degrees)
            m_sharpest = {sharpness, (from + to) / 2};
        if (sharpness < leastCrease)
            continue;
        creased->InsertNextCell({first, last});
        const double density = std::min(1.0, sharpness / densestCrease);
        const std::array<unsigned char, 4> band = {m_creaseColour.r, m_creaseColour.g, m_creaseColour.b,
                                                   static_cast<unsigned char>(std::lround(255 * density))};
        bands->InsertNextTypedTuple(band.data());
    }
    m_line->SetPoints(points);
    m_line->SetLines(lines);
    m_crease->SetPoints(points);
    m_crease->SetLines(creased);
    m_crease->GetCellData()->SetScalars(bands);
}

void PlaneLayer::clearPartingLine() {
    m_line->Initialize();
    m_crease->Initialize();
    m_sharpest = {};
}

void PlaneLayer::setColours(const SceneColours& colours, double scale) {
    m_sheetActor->GetProperty()->SetColor(colours.plane.unit().data());
    m_sheetActor->GetProperty()->SetOpacity(colours.planeOpacity);
    m_outlineActor->GetProperty()->SetColor(colours.plane.unit().data());
    m_outlineActor->GetProperty()->SetLineWidth(static_cast<float>(1.6 * scale));
    m_lineActor->GetProperty()->SetColor(colours.partingLine.unit().data());
    m_lineActor->GetProperty()->SetLineWidth(static_cast<float>(1.7 * scale));
    m_creaseColour = colours.crease; // taken with the next parting line
    m_creaseActor->GetProperty()->SetLineWidth(static_cast<float>(5 * scale));
}

} // namespace moldwright::scene

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/cut_layer.h"

#include "mold/section.h"

#include <vtkCellArray.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

namespace moldwright::scene {

namespace {

void prepareFlat(vtkRenderer* renderer, vtkPolyData* data, vtkPolyDataMapper* mapper, vtkActor* actor) {
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    renderer->AddActor(actor);
}

PartingPlane seenFrom(const Eigen::Isometry3d& pose, const PartingPlane& cut) {
    return {pose.linear().transpose() * cut.normal, cut.offset - cut.normal.dot(pose.translation())};
}

} // namespace

void cutMapper(vtkPolyDataMapper* mapper, const std::optional<PartingPlane>& cut) {
    mapper->RemoveAllClippingPlanes();
    if (!cut)
        return;
    const vtkNew<vtkPlane> plane;
    plane->SetNormal(Eigen::Vector3d(-cut->normal).data());
    plane->SetOrigin(Eigen::Vector3d(cut->offset * cut->normal).data());
    mapper->AddClippingPlane(plane);
}

CutLayer::CutLayer(vtkRenderer* renderer) {
    prepareFlat(renderer, m_fill, m_fillMapper, m_fillActor);
    prepareFlat(renderer, m_line, m_lineMapper, m_lineActor);
    // Faces of the solid may lie in the plane: the section is drawn a little nearer, its outline nearer
    // still.
    m_fillMapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, -4);
    m_lineMapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -8);
}

void CutLayer::set(const SharedMesh& mesh, const Eigen::Isometry3d& pose,
                   const std::optional<PartingPlane>& cut) {
    m_fill->Initialize();
    m_line->Initialize();
    if (!mesh || !cut)
        return;
    const Section section = sectionOf(*mesh, seenFrom(pose, *cut));
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (int v = 0; v < section.fill.vertexCount(); ++v)
        points->InsertNextPoint(Eigen::Vector3d(pose * section.fill.point(v)).data());
    const vtkNew<vtkCellArray> triangles;
    for (int f = 0; f < section.fill.faceCount(); ++f)
        triangles->InsertNextCell({section.fill.F(f, 0), section.fill.F(f, 1), section.fill.F(f, 2)});
    const vtkNew<vtkCellArray> lines;
    for (const auto& [from, to] : section.outline)
        lines->InsertNextCell({from, to});
    m_fill->SetPoints(points);
    m_fill->SetPolys(triangles);
    m_line->SetPoints(points);
    m_line->SetLines(lines);
}

void CutLayer::setLook(Rgb fill, Rgb line, double lineWidth) {
    m_fillActor->GetProperty()->SetColor(fill.unit().data());
    m_lineActor->GetProperty()->SetColor(line.unit().data());
    m_lineActor->GetProperty()->SetLineWidth(static_cast<float>(lineWidth));
}

void CutLayer::setVisible(bool visible) {
    m_fillActor->SetVisibility(visible);
    m_lineActor->SetVisibility(visible);
}

} // namespace moldwright::scene

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/surface_picker.h"

#include "mesh/measures.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

namespace moldwright::scene {

struct SurfacePicker::Locator {
    vtkNew<vtkPolyData> surface;
    vtkNew<vtkStaticCellLocator> cells;
    double reach = 0; ///< far enough to pass the whole surface, mm
};

SurfacePicker::SurfacePicker(SharedMesh mesh)
    : m_mesh(std::move(mesh)), m_locator(std::make_unique<Locator>()) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(m_mesh->V.rows());
    for (int v = 0; v < m_mesh->vertexCount(); ++v)
        points->SetPoint(v, m_mesh->V.row(v).data());
    vtkNew<vtkCellArray> faces;
    for (int f = 0; f < m_mesh->faceCount(); ++f)
        faces->InsertNextCell({m_mesh->F(f, 0), m_mesh->F(f, 1), m_mesh->F(f, 2)});
    m_locator->surface->SetPoints(points);
    m_locator->surface->SetPolys(faces);
    m_locator->cells->SetDataSet(m_locator->surface);
    m_locator->cells->BuildLocator();
    m_locator->reach = diagonal(*m_mesh);
}

SurfacePicker::~SurfacePicker() = default;

std::optional<SurfacePicker::Hit> SurfacePicker::pick(const Ray& ray) const {
    const Eigen::AlignedBox3d box = boundingBox(*m_mesh);
    if (box.isEmpty())
        return std::nullopt;
    // The locator's search is exact to a share of the segment's length: keep the segment about the part.
    const double middle = (box.center() - ray.origin).dot(ray.direction);
    const Eigen::Vector3d from = ray.origin + (middle - m_locator->reach) * ray.direction;
    const Eigen::Vector3d to = ray.origin + (middle + m_locator->reach) * ray.direction;
    double t = 0;
    Hit hit;
    double parameters[3];
    int part = 0;
    vtkIdType face = -1;
    if (!m_locator->cells->IntersectWithLine(from.data(), to.data(), 1e-9 * m_locator->reach, t,
                                             hit.point.data(), parameters, part, face))
        return std::nullopt;
    hit.face = static_cast<int>(face);
    return hit;
}

} // namespace moldwright::scene

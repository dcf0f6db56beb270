// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/surface_picker.h"

#include "mesh/measures.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace moldwright::scene {

struct SurfacePicker::Locator {
    vtkNew<vtkPolyData> surface;
    vtkNew<vtkStaticCellLocator> cells;
    Eigen::AlignedBox3d box;
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
    m_locator->box = boundingBox(*m_mesh);
    m_locator->reach = diagonal(*m_mesh);
}

SurfacePicker::~SurfacePicker() = default;

std::optional<SurfacePicker::Hit> SurfacePicker::firstFrom(const Ray& ray, double start) const {
    if (m_locator->box.isEmpty())
        return std::nullopt;
    // The locator's search is exact to a share of the segment's length: keep the segment about the part.
    const double middle = (m_locator->box.center() - ray.origin).dot(ray.direction);
    const double end = middle + m_locator->reach;
    start = std::max(start, middle - m_locator->reach);
    if (start >= end)
        return std::nullopt;
    const Eigen::Vector3d from = ray.origin + start * ray.direction;
    const Eigen::Vector3d to = ray.origin + end * ray.direction;
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

std::optional<SurfacePicker::Hit> SurfacePicker::pick(const Ray& ray,
                                                      const std::optional<PartingPlane>& cut) const {
    constexpr double fromAfar = -std::numeric_limits<double>::infinity();
    if (!cut)
        return firstFrom(ray, fromAfar);
    const double fall = -cut->normal.dot(ray.direction);
    if (fall <= 0) { // seen from behind
        const std::optional<Hit> hit = firstFrom(ray, fromAfar);
        return hit && cut->distance(hit->point) <= 0 ? hit : std::nullopt;
    }
    const double start = cut->distance(ray.origin) / fall;
    const std::optional<Hit> hit = firstFrom(ray, start);
    // From within the solid its surface is met from inside first: what the eye meets is the section.
    if (hit && doubleAreaVector(*m_mesh, hit->face).dot(ray.direction) > 0)
        return Hit{-1, ray.origin + start * ray.direction};
    return hit;
}

std::optional<Eigen::Vector3d> SurfacePicker::middleBelow(const Hit& hit, const Ray& ray) const {
    const std::optional<Hit> out = firstFrom({hit.point, ray.direction}, 1e-6 * m_locator->reach);
    if (!out)
        return std::nullopt;
    return (hit.point + out->point) / 2;
}

double SurfacePicker::distance(const Eigen::Vector3d& point) const {
    Eigen::Vector3d nearest;
    vtkIdType face = -1;
    int part = 0;
    double squared = 0;
    m_locator->cells->FindClosestPoint(point.data(), nearest.data(), face, part, squared);
    return std::sqrt(squared);
}

std::optional<double> SurfacePicker::thickness(const Hit& hit) const {
    const Eigen::Vector3d inwards = -doubleAreaVector(*m_mesh, hit.face).normalized();
    const std::optional<Hit> across = firstFrom({hit.point, inwards}, 1e-6 * m_locator->reach);
    if (!across)
        return std::nullopt;
    return (across->point - hit.point).norm();
}

} // namespace moldwright::scene

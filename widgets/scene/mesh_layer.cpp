// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/mesh_layer.h"

#include "scene/shading.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <vector>

namespace moldwright::scene {

namespace {

vtkNew<vtkFloatArray> rowsAsArray(const Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>& rows) {
    vtkNew<vtkFloatArray> array;
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(rows.rows());
    std::copy_n(rows.data(), rows.size(), array->GetPointer(0));
    return array;
}

vtkNew<vtkCellArray> facesAsCells(const Triangles& faces) {
    vtkNew<vtkTypeInt32Array> starts;
    starts->SetNumberOfValues(faces.rows() + 1);
    for (vtkIdType f = 0; f <= faces.rows(); ++f)
        starts->SetValue(f, static_cast<int>(3 * f));
    vtkNew<vtkTypeInt32Array> corners;
    corners->SetNumberOfValues(faces.size());
    std::copy_n(faces.data(), faces.size(), corners->GetPointer(0));
    vtkNew<vtkCellArray> cells;
    cells->SetData(starts, corners);
    return cells;
}

} // namespace

MeshLayer::MeshLayer() {
    m_mapper->SetInputData(m_surface);
    m_mapper->SetColorModeToDirectScalars();
    m_mapper->SetScalarModeToUseCellData();
    m_mapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_actor->SetMapper(m_mapper);
    vtkProperty* look = m_actor->GetProperty();
    look->SetInterpolationToPhong();
    look->SetAmbient(0.22);
    look->SetDiffuse(0.88);
    look->SetSpecular(0.10);
    look->SetSpecularPower(24);
    look->SetEdgeColor(0.25, 0.28, 0.32);
    look->BackfaceCullingOn(); // surfaces are closed: their backs are never seen, and cost as much
    m_actor->VisibilityOff();
}

void MeshLayer::setMesh(const SharedMesh& mesh, Rgb colour) {
    m_mesh = mesh;
    m_actor->SetVisibility(mesh != nullptr);
    if (!mesh)
        return;
    const ShadedMesh shaded = shade(*mesh);
    vtkNew<vtkPoints> points;
    points->SetData(rowsAsArray(shaded.points));
    m_surface->SetPoints(points);
    m_surface->GetPointData()->SetNormals(rowsAsArray(shaded.normals));
    m_surface->SetPolys(facesAsCells(shaded.faces));
    setFaceColours(std::vector<Rgb>(mesh->F.rows(), colour));
}

void MeshLayer::setOpacity(double opacity) {
    m_actor->GetProperty()->SetOpacity(opacity);
    m_actor->GetProperty()->SetBackfaceCulling(opacity == 1);
}

void MeshLayer::setFaceColours(std::span<const Rgb> colours) {
    if (!m_mesh || static_cast<Eigen::Index>(colours.size()) != m_mesh->F.rows())
        return;
    vtkNew<vtkUnsignedCharArray> array;
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(colours.size()));
    static_assert(sizeof(Rgb) == 3);
    std::copy_n(reinterpret_cast<const unsigned char*>(colours.data()), 3 * colours.size(),
                array->GetPointer(0));
    m_surface->GetCellData()->SetScalars(array);
    m_surface->Modified();
}

} // namespace moldwright::scene

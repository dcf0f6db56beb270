// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "scene/colours.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <span>

namespace moldwright::scene {

/// One surface in the view: smooth shading with creases, one colour per face.
class MeshLayer {
public:
    MeshLayer();

    /// Shows another mesh in one colour; null hides.
    void setMesh(const SharedMesh& mesh, Rgb colour);

    /// One colour per face of the mesh shown.
    void setFaceColours(std::span<const Rgb> colours);

    /// See-through from 0 to 1; 1 is solid.
    void setOpacity(double opacity);
    void setEdges(bool shown) { m_actor->GetProperty()->SetEdgeVisibility(shown); }

    [[nodiscard]] const SharedMesh& mesh() const { return m_mesh; }
    [[nodiscard]] vtkActor* actor() const { return m_actor; }

private:
    SharedMesh m_mesh;
    vtkNew<vtkPolyData> m_surface;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

} // namespace moldwright::scene

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"
#include "scene/colours.h"

#include <Eigen/Geometry>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <optional>

namespace moldwright::scene {

/// Lets a mapper draw only what lies behind the plane (n·x < o), in the scene's frame; without one all.
void cutMapper(vtkPolyDataMapper* mapper, const std::optional<PartingPlane>& cut);

/// Where one solid is cut open: the section filled in a flat colour, and its outline.
class CutLayer {
public:
    explicit CutLayer(vtkRenderer* renderer);

    /// The section of `mesh`, which is shown moved by `pose`, at `cut` (mm, in the scene's frame). A null
    /// mesh or no cut hides it.
    void set(const SharedMesh& mesh, const Eigen::Isometry3d& pose, const std::optional<PartingPlane>& cut);
    void setLook(Rgb fill, Rgb line, double lineWidth);
    void setVisible(bool visible);

private:
    vtkNew<vtkPolyData> m_fill;
    vtkNew<vtkPolyDataMapper> m_fillMapper;
    vtkNew<vtkActor> m_fillActor;
    vtkNew<vtkPolyData> m_line;
    vtkNew<vtkPolyDataMapper> m_lineMapper;
    vtkNew<vtkActor> m_lineActor;
};

} // namespace moldwright::scene

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "scene/colours.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

namespace moldwright::scene {

/// Walls that are not there yet, as glass.
class FillingLayer {
public:
    FillingLayer();

    /// Null: none.
    void set(const SharedMesh& walls);
    [[nodiscard]] const SharedMesh& walls() const { return m_walls; }
    void setColour(Rgb colour);

    [[nodiscard]] vtkActor* actor() const { return m_actor; }

private:
    SharedMesh m_walls;
    vtkNew<vtkPolyData> m_data;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

} // namespace moldwright::scene

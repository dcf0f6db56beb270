// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "scene/colours.h"
#include "scene/cut_layer.h"
#include "scene/plane_handle.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

namespace moldwright::scene {

/// The parting plane in the view: a see-through rectangle with its outline, and the parting line.
class PlaneLayer {
public:
    PlaneLayer();

    void setPlane(const PlaneRectangle& rectangle);
    void setPartingLine(const IndexedMesh& mesh, const PartingPlane& plane);
    void clearPartingLine();
    /// Cuts the parting line as the surface is cut.
    void setCut(const std::optional<PartingPlane>& cut) { cutMapper(m_lineMapper, cut); }
    void setColours(const SceneColours& colours, double scale);

    [[nodiscard]] vtkActor* sheet() const { return m_sheetActor; }
    [[nodiscard]] vtkActor* outline() const { return m_outlineActor; }
    [[nodiscard]] vtkActor* partingLine() const { return m_lineActor; }

private:
    vtkNew<vtkPolyData> m_sheet;
    vtkNew<vtkPolyData> m_outline;
    vtkNew<vtkPolyData> m_line;
    vtkNew<vtkPolyDataMapper> m_sheetMapper;
    vtkNew<vtkPolyDataMapper> m_outlineMapper;
    vtkNew<vtkPolyDataMapper> m_lineMapper;
    vtkNew<vtkActor> m_sheetActor;
    vtkNew<vtkActor> m_outlineActor;
    vtkNew<vtkActor> m_lineActor;
};

} // namespace moldwright::scene

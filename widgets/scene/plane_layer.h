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

/// Where the surface is creased most sharply along its parting line.
struct SharpestCrease {
    double degrees = 0;
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< mm
};

/// The parting plane in the view: a see-through rectangle with its outline, and the parting line. Where
/// directions that are not parallel leave a crease, the line has a band that is denser the sharper it is.
class PlaneLayer {
public:
    PlaneLayer();

    void setPlane(const PlaneRectangle& rectangle);
    void setPartingLine(const IndexedMesh& mesh, const MoldState& state);
    /// Of the parting line as it was set.
    [[nodiscard]] const SharpestCrease& sharpestCrease() const { return m_sharpest; }
    void clearPartingLine();
    /// Cuts the parting line as the surface is cut.
    void setCut(const std::optional<PartingPlane>& cut) {
        cutMapper(m_lineMapper, cut);
        cutMapper(m_creaseMapper, cut);
    }
    void setColours(const SceneColours& colours, double scale);

    [[nodiscard]] vtkActor* sheet() const { return m_sheetActor; }
    [[nodiscard]] vtkActor* outline() const { return m_outlineActor; }
    [[nodiscard]] vtkActor* partingLine() const { return m_lineActor; }
    [[nodiscard]] vtkActor* crease() const { return m_creaseActor; }

private:
    vtkNew<vtkPolyData> m_sheet;
    vtkNew<vtkPolyData> m_outline;
    vtkNew<vtkPolyData> m_line;
    vtkNew<vtkPolyData> m_crease;
    vtkNew<vtkPolyDataMapper> m_creaseMapper;
    vtkNew<vtkActor> m_creaseActor;
    SharpestCrease m_sharpest;
    Rgb m_creaseColour;
    vtkNew<vtkPolyDataMapper> m_sheetMapper;
    vtkNew<vtkPolyDataMapper> m_outlineMapper;
    vtkNew<vtkPolyDataMapper> m_lineMapper;
    vtkNew<vtkActor> m_sheetActor;
    vtkNew<vtkActor> m_outlineActor;
    vtkNew<vtkActor> m_lineActor;
};

} // namespace moldwright::scene

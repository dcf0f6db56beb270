// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/colours.h"

#include <Eigen/Core>

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>

#include <vector>

namespace moldwright::scene {

/// Straight lines from place to place, drawn over everything.
class PathLayer {
public:
    PathLayer();

    /// Fewer than two places draw nothing. mm.
    void set(const std::vector<Eigen::Vector3d>& places);
    void setLook(Rgb colour, double lineWidth);

    [[nodiscard]] vtkActor2D* actor() const { return m_actor; }

private:
    vtkNew<vtkPolyData> m_line;
    vtkNew<vtkPolyDataMapper2D> m_mapper;
    vtkNew<vtkActor2D> m_actor;
};

} // namespace moldwright::scene

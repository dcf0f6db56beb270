// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/colours.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace moldwright::scene {

/// Edges where a surface is at fault, as lines in it, hidden where it is nearer: the rims of its holes.
class FaultLayer {
public:
    using Edge = std::array<Eigen::Vector3d, 2>;

    FaultLayer();

    /// From where to where each runs; none draws nothing. mm.
    void set(const std::vector<Edge>& edges);
    [[nodiscard]] int edgeCount() const { return static_cast<int>(m_lines->GetNumberOfLines()); }
    void setLook(Rgb colour, double lineWidth);

    [[nodiscard]] vtkActor* actor() const { return m_actor; }

private:
    vtkNew<vtkPolyData> m_lines;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

} // namespace moldwright::scene

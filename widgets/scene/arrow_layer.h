// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/colours.h"

#include <Eigen/Core>

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>

namespace moldwright::scene {

/// A removal direction in the view: a solid arrow.
class ArrowLayer {
public:
    ArrowLayer();

    /// From `tail` along the unit `direction`, `length` mm long.
    void set(const Eigen::Vector3d& tail, const Eigen::Vector3d& direction, double length);
    void setColour(Rgb colour);

    [[nodiscard]] vtkActor* actor() const { return m_actor; }

private:
    vtkNew<vtkArrowSource> m_shape;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

} // namespace moldwright::scene

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/direction_limits.h"
#include "scene/colours.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

namespace moldwright::scene {

/// Where a removal direction may point: a see-through collar about its arrow, with the rim that the arrow's
/// tip must keep within.
class ConeLayer {
public:
    ConeLayer();

    /// The directions of `cap` from `middle`, drawn between `near` and `far` mm from there.
    void set(const DirectionCap& cap, const Eigen::Vector3d& middle, double near, double far);
    void setLook(Rgb colour, double scale);

    [[nodiscard]] vtkActor* collar() const { return m_collarActor; }
    [[nodiscard]] vtkActor* rim() const { return m_rimActor; }

private:
    vtkNew<vtkPolyData> m_collar;
    vtkNew<vtkPolyData> m_rim;
    vtkNew<vtkPolyDataMapper> m_collarMapper;
    vtkNew<vtkPolyDataMapper> m_rimMapper;
    vtkNew<vtkActor> m_collarActor;
    vtkNew<vtkActor> m_rimActor;
};

} // namespace moldwright::scene

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/path_layer.h"

#include <Eigen/Core>

#include <vector>

class vtkRenderer;

namespace moldwright::scene {

/// The line under the hand that paints: the brush's circle, or the lasso as far as it is drawn. Dark with a
/// light edge, so that it is seen on any colour.
class BrushLayer {
public:
    void addTo(vtkRenderer* renderer);
    void setScale(double scale);

    /// Fewer than two places draw nothing. mm.
    void set(const std::vector<Eigen::Vector3d>& places);
    [[nodiscard]] const std::vector<Eigen::Vector3d>& places() const { return m_places; }

private:
    std::vector<Eigen::Vector3d> m_places;
    PathLayer m_edge;
    PathLayer m_line;
};

/// A circle about a point, square to `normal` (unit), its end joined. mm.
[[nodiscard]] std::vector<Eigen::Vector3d> circleAbout(const Eigen::Vector3d& middle,
                                                       const Eigen::Vector3d& normal, double radius);

} // namespace moldwright::scene

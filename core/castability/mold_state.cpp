// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/mold_state.h"

namespace moldwright {

std::array<Eigen::Vector3d, 2> planeAxes(const Eigen::Vector3d& n) {
    // The coordinate axis least aligned with n keeps the cross product far from zero.
    Eigen::Index axis = 0;
    n.cwiseAbs().minCoeff(&axis);
    const Eigen::Vector3d x = Eigen::Vector3d::Unit(axis).cross(n).normalized();
    return {x, n.cross(x)};
}

Eigen::Isometry3d planeFrame(const PartingPlane& plane) {
    const auto [x, y] = planeAxes(plane.normal);
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    frame.linear().row(0) = x.transpose();
    frame.linear().row(1) = y.transpose();
    frame.linear().row(2) = plane.normal.transpose();
    frame.translation() = Eigen::Vector3d(0, 0, -plane.offset);
    return frame;
}

} // namespace moldwright

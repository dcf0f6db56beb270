// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace moldwright {

/// Barycentric weights of the point of a triangle nearest to p: none below 0, their sum 1. [Ericson 2005],
/// Section 5.1.5
[[nodiscard]] Eigen::Vector3d nearestOnTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                                const Eigen::Vector3d& b, const Eigen::Vector3d& c);

} // namespace moldwright

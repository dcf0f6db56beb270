// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/project.h"

#include <Eigen/Geometry>

namespace moldwright {

/// How many millimetres one of these is.
[[nodiscard]] double millimetres(Unit unit);

/// The placement after moving the part as it lies by `motion` (in the part's frame).
[[nodiscard]] Placement moved(const Placement& placement, const Eigen::Isometry3d& motion);

/// The motion that lays the part down on a face with this outward unit normal: the normal looks down, the
/// lowest point is at z = 0.
[[nodiscard]] Eigen::Isometry3d layFlat(const IndexedMesh& part, const Eigen::Vector3d& normal);

/// The turn of the part by an angle about the unit `axis` through the middle of its box.
[[nodiscard]] Eigen::Isometry3d turnAbout(const IndexedMesh& part, const Eigen::Vector3d& axis,
                                          double degrees);

/// The exact quarter turn of the part about `axis` (a coordinate axis, unit) through the middle of its box.
[[nodiscard]] Eigen::Isometry3d quarterTurn(const IndexedMesh& part, const Eigen::Vector3d& axis);

} // namespace moldwright

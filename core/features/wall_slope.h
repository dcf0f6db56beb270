// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace moldwright {

/// How far a wall that stands on the parting plane must lean inwards: the least k, in mm of inset per mm of
/// height, with N·d ≥ sin(draft) for each of `directions` (unit). With m the unit normal of its foot, looking
/// out of the body in the plane, and e the plane's normal on its side (+z for 1, −z for 2),
///
///     N = (m + k e) / √(1+k²),   k = tan(asin(sin(draft)/ρ) − atan2(m·d, e·d)),   ρ = √((m·d)² + (e·d)²).
///
/// Along the tilt of a direction the wall on one side leans more and the other less, even outwards (k < 0):
/// the section then follows the direction. None when sin(draft) > ρ, or where directions contradict each
/// other.
[[nodiscard]] std::optional<double> wallSlope(const Eigen::Vector2d& m, int side,
                                              const std::vector<Eigen::Vector3d>& directions,
                                              double draftDegrees);

} // namespace moldwright

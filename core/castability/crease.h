// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"

#include <Eigen/Core>

namespace moldwright {

/// How sharply a surface must at least be creased where its parting line runs along `tangent` (in the plane,
/// any length): the angle, degrees, between d1 and −d2 seen along the line. Walls of either side that lean as
/// far as their direction lets them meet at this angle; 0 where the directions are parallel, or lean along
/// the line only. [Stein 2019], Fig. 5.
[[nodiscard]] double creaseDegrees(const MoldState& state, const Eigen::Vector3d& tangent);

/// The sharpest crease that any parting line of the state can have, degrees: where it runs square to the way
/// in which the directions differ.
[[nodiscard]] double sharpestCreaseDegrees(const MoldState& state);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/direction_limits.h"
#include "castability/mold_state.h"
#include "scene/camera.h"

#include <Eigen/Core>

namespace moldwright::scene {

/// How a removal direction leans from the normal of its side: the angle between them, and the way it leans,
/// counted in the plane from planeAxes()[0] to planeAxes()[1], 0° … 360°.
struct Lean {
    double tiltDegrees = 0;
    double wayDegrees = 0;
};

/// `side` is 1 or 2; the normal of side 2 is −n.
[[nodiscard]] Lean leanOf(const MoldState& state, int side);

/// The unit direction that leans like this.
[[nodiscard]] Eigen::Vector3d leaning(const PartingPlane& plane, int side, const Lean& lean);

/// `state` with another direction of one side.
[[nodiscard]] MoldState withDirection(const MoldState& state, int side, const Eigen::Vector3d& direction);

/// A drag of an arrow's tip, from the state it started in. The arrow turns about the middle of the part;
/// within 2° of the normal it snaps to it, and it never leaves the limits. `coarse` rounds to 5°
/// of tilt and 15° of way.
struct DirectionDrag {
    MoldState start;
    int side = 1;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(); ///< mm
    Eigen::Vector3d tip = Eigen::Vector3d::UnitZ();   ///< mm, where the drag began
    DirectionLimits limits;
    double x = 0; ///< pixel where the drag began
    double y = 0;

    /// The state with the pointer at (x, y).
    [[nodiscard]] MoldState moved(const Camera& camera, ViewSize view, double toX, double toY,
                                  bool coarse) const;
};

} // namespace moldwright::scene

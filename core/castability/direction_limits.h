// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"

#include <Eigen/Core>

#include <optional>

namespace moldwright {

/// Where removal directions may point. Presses and casting machines pull along an axis of their own: with one
/// given, both directions stay about it, whichever way round.
struct DirectionLimits {
    double maxTiltDegrees = 30;               ///< from the normal of the plane, < 90
    std::optional<Eigen::Vector3d> axis = {}; ///< unit; none: any way
    double coneDegrees = 0;                   ///< from the axis; 0: along it

    bool operator==(const DirectionLimits&) const = default;
};

/// The limits of directions that stand along the normal: they do not tilt.
[[nodiscard]] DirectionLimits alongNormal(DirectionLimits limits);

/// Directions within an angle of a middle.
struct DirectionCap {
    Eigen::Vector3d middle = Eigen::Vector3d::UnitZ(); ///< unit
    double radiusDegrees = 0;

    /// The direction in the cap nearest to a unit one.
    [[nodiscard]] Eigen::Vector3d nearestTo(const Eigen::Vector3d& direction) const;
};

/// The largest cap within all limits, for the direction of a side at a plane of unit normal; none where they
/// exclude each other. All that is allowed lies in it where one limit encloses the other.
[[nodiscard]] std::optional<DirectionCap> capWithin(const DirectionLimits& limits,
                                                    const Eigen::Vector3d& normal, int side);

/// Whether any directions are allowed at a plane of this normal.
[[nodiscard]] bool allows(const DirectionLimits& limits, const Eigen::Vector3d& normal);

/// The middles of both sides' caps: the natural directions at a plane. Precondition: it allows any.
[[nodiscard]] Directions middleDirections(const DirectionLimits& limits, const Eigen::Vector3d& normal);

} // namespace moldwright

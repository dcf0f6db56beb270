// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/direction_limits.h"

#include <cmath>

namespace moldwright {

namespace {

constexpr double kHair = 1e-9; ///< degrees: touching limits do not exclude each other

/// Degrees between unit vectors, exact where they are close.
double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
}

/// `from` turned towards `to`.
Eigen::Vector3d turned(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double angle) {
    const Eigen::Vector3d across = to - from * from.dot(to);
    const double length = across.norm();
    if (!(length > 0) || angle == 0)
        return from;
    return (std::cos(radians(angle)) * from + std::sin(radians(angle)) / length * across).normalized();
}

} // namespace

DirectionLimits alongNormal(DirectionLimits limits) {
    limits.maxTiltDegrees = 0;
    return limits;
}

Eigen::Vector3d DirectionCap::nearestTo(const Eigen::Vector3d& direction) const {
    return angleBetween(middle, direction) <= radiusDegrees ? direction
                                                            : turned(middle, direction, radiusDegrees);
}

std::optional<DirectionCap> capWithin(const DirectionLimits& limits, const Eigen::Vector3d& normal,
                                      int side) {
    const Eigen::Vector3d out = side == 1 ? normal : -normal;
    const double tilt = limits.maxTiltDegrees;
    const double cone = limits.coneDegrees;
    if (!limits.axis)
        return DirectionCap{out, tilt};
    const Eigen::Vector3d axis = limits.axis->dot(out) >= 0 ? *limits.axis : -*limits.axis;
    const double between = angleBetween(out, axis);
    if (between > tilt + cone + kHair)
        return std::nullopt;
    if (between + cone <= tilt + kHair)
        return DirectionCap{axis, cone};
    if (between + tilt <= cone)
        return DirectionCap{out, tilt};
    // Of two caps that overlap, the largest one in both has its middle on the arc between theirs.
    const double radius = std::max(0.0, (tilt + cone - between) / 2);
    return DirectionCap{turned(out, axis, tilt - radius), radius};
}

bool allows(const DirectionLimits& limits, const Eigen::Vector3d& normal) {
    return capWithin(limits, normal, 1).has_value();
}

Directions middleDirections(const DirectionLimits& limits, const Eigen::Vector3d& normal) {
    return {capWithin(limits, normal, 1)->middle, capWithin(limits, normal, 2)->middle};
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/direction_handle.h"

#include <algorithm>
#include <cmath>

namespace moldwright::scene {

namespace {

constexpr double snapDegrees = 2;
constexpr double coarseTilt = 5;
constexpr double coarseWay = 15;

double sign(int side) {
    return side == 1 ? 1 : -1;
}

/// The point under a pixel at the depth of `place`.
Eigen::Vector3d atDepthOf(const Eigen::Vector3d& place, const Camera& camera, ViewSize view, double x,
                          double y) {
    const Ray ray = camera.rayAt(x, y, view);
    const Eigen::Vector3d back = camera.backwards();
    return ray.origin + back.dot(place - ray.origin) / back.dot(ray.direction) * ray.direction;
}

} // namespace

Lean leanOf(const MoldState& state, int side) {
    const Eigen::Vector3d& d = state.directions.of(side);
    const auto [u, v] = planeAxes(state.plane.normal);
    const Eigen::Vector2d across(d.dot(u), d.dot(v));
    const double along = sign(side) * d.dot(state.plane.normal);
    // Below a millionth of a degree the way is noise.
    if (across.norm() < 1e-8)
        return {along >= 0 ? 0.0 : 180.0, 0};
    const double way = degrees(std::atan2(across.y(), across.x()));
    // A hair below zero is zero, not 360°.
    return {degrees(std::atan2(across.norm(), along)), way < -1e-9 ? way + 360 : std::max(way, 0.0)};
}

Eigen::Vector3d leaning(const PartingPlane& plane, int side, const Lean& lean) {
    const auto [u, v] = planeAxes(plane.normal);
    const double tilt = radians(lean.tiltDegrees);
    const double way = radians(lean.wayDegrees);
    const Eigen::Vector3d across = std::cos(way) * u + std::sin(way) * v;
    if (lean.tiltDegrees == 0)
        return sign(side) * plane.normal;
    return (sign(side) * std::cos(tilt) * plane.normal + std::sin(tilt) * across).normalized();
}

MoldState withDirection(const MoldState& state, int side, const Eigen::Vector3d& direction) {
    MoldState other = state;
    (side == 1 ? other.directions.d1 : other.directions.d2) = direction;
    return other;
}

MoldState DirectionDrag::moved(const Camera& camera, ViewSize view, double toX, double toY,
                               bool coarse) const {
    // The tip keeps its distance from the pointer that it had when it was taken hold of.
    const Eigen::Vector3d pixel = camera.project(tip, view);
    const Eigen::Vector3d to = atDepthOf(tip, camera, view, pixel.x() + toX - x, pixel.y() + toY - y);
    if ((to - middle).norm() == 0)
        return start;
    Lean lean = leanOf(withDirection(start, side, (to - middle).normalized()), side);
    if (coarse)
        lean = {std::round(lean.tiltDegrees / coarseTilt) * coarseTilt,
                std::round(lean.wayDegrees / coarseWay) * coarseWay};
    else if (lean.tiltDegrees < snapDegrees)
        lean = {};
    const std::optional<DirectionCap> cap = capWithin(limits, start.plane.normal, side);
    const Eigen::Vector3d wanted = leaning(start.plane, side, lean);
    return cap ? withDirection(start, side, cap->nearestTo(wanted)) : start;
}

} // namespace moldwright::scene

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/crease.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

/// How far a direction on side 1 leans from the normal towards `across`, radians.
double leanTowards(const Eigen::Vector3d& d, const Eigen::Vector3d& normal, const Eigen::Vector3d& across) {
    return std::atan2(d.dot(across), d.dot(normal));
}

} // namespace

double creaseDegrees(const MoldState& state, const Eigen::Vector3d& tangent) {
    const Eigen::Vector3d& n = state.plane.normal;
    const Eigen::Vector3d across = n.cross(tangent).normalized();
    const Eigen::Vector3d down = -state.directions.d2;
    return degrees(std::abs(leanTowards(state.directions.d1, n, across) - leanTowards(down, n, across)));
}

double sharpestCreaseDegrees(const MoldState& state) {
    // The lean seen along a line depends on its way smoothly, with one maximum in half a turn: a scan and a
    // few halvings find it.
    const auto [u, v] = planeAxes(state.plane.normal);
    const auto at = [&, u = u, v = v](double angle) {
        return creaseDegrees(state, std::cos(angle) * u + std::sin(angle) * v);
    };
    constexpr int looks = 180;
    double best = 0;
    for (int k = 1; k < looks; ++k)
        if (at(k * std::numbers::pi / looks) > at(best))
            best = k * std::numbers::pi / looks;
    for (double step = std::numbers::pi / looks / 2; step > 1e-9; step /= 2)
        for (const double way : {-step, step})
            if (at(best + way) > at(best))
                best += way;
    return at(best);
}

} // namespace moldwright

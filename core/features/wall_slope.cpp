// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/wall_slope.h"

#include "castability/mold_state.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace moldwright {

std::optional<double> wallSlope(const Eigen::Vector2d& m, int side,
                                const std::vector<Eigen::Vector3d>& directions, double draftDegrees) {
    const double tau = std::sin(radians(draftDegrees));
    // N·d = ρ sin(θ + φ) with k = tan θ: at least τ between two angles.
    double least = -std::numbers::pi / 2;
    double most = std::numbers::pi / 2;
    for (const Eigen::Vector3d& d : directions) {
        const double across = m.dot(d.head<2>());
        const double up = side == 1 ? d.z() : -d.z();
        const double rho = std::hypot(across, up);
        if (up <= 0 || tau > rho)
            return std::nullopt;
        const double phi = std::atan2(across, up);
        least = std::max(least, std::asin(tau / rho) - phi);
        most = std::min(most, std::numbers::pi - std::asin(tau / rho) - phi);
    }
    constexpr double flat = 1e-3; // a wall this near to the plane is none
    if (least > most || least > std::numbers::pi / 2 - flat)
        return std::nullopt;
    return std::tan(least);
}

} // namespace moldwright

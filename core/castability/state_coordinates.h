// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/energy.h"
#include "castability/mold_state.h"

namespace moldwright {

/// How directions follow a plane that moves.
enum class DirectionsFollow {
    Freely, ///< they have numbers of their own
    Normal, ///< d1 = n, d2 = −n
    Held    ///< they stay as they are at the start
};

/// Plane and directions as free numbers x: two tilts of a start's normal, the offset's change, and where
/// directions move freely two for each. Every x is allowed: d = normalize(n + r(c)·P·T·c) with P the
/// projection along n, r(c) = tan(tilt cap)/√(1+|c|²), so that d·n > 0 and the cap hold by construction.
class StateCoordinates {
public:
    /// The tilt cap counts where directions move freely.
    StateCoordinates(const MoldState& start, double maxTiltDegrees, DirectionsFollow follow);

    /// The start's own numbers; directions outside the cap are brought to its rim.
    [[nodiscard]] Eigen::VectorXd origin() const;
    [[nodiscard]] MoldState state(const Eigen::VectorXd& x) const;
    /// Gradient with respect to x from that with respect to state(x).
    void pullBack(const Eigen::VectorXd& x, const StateGradient& g, Eigen::VectorXd& gradient) const;

private:
    [[nodiscard]] Eigen::Vector2d numbersOf(const Eigen::Vector3d& d) const;
    [[nodiscard]] Eigen::Vector3d leaning(const Eigen::Vector3d& n, const Eigen::Vector2d& c) const;
    Eigen::Vector3d pullBackLeaning(const Eigen::Vector3d& n, const Eigen::Vector2d& c,
                                    const Eigen::Vector3d& g, Eigen::Ref<Eigen::VectorXd> gradientC) const;

    MoldState m_start;
    DirectionsFollow m_follow;
    double m_reach; ///< tan of the tilt cap
    Eigen::Matrix<double, 3, 2> m_tangents;
};

} // namespace moldwright

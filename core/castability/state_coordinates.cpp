// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/state_coordinates.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr double kRim = 0.98;

} // namespace

StateCoordinates::StateCoordinates(const MoldState& start, double maxTiltDegrees, DirectionsFollow follow)
    : m_start(start), m_follow(follow), m_reach(std::tan(radians(maxTiltDegrees))) {
    const auto [x, y] = planeAxes(start.plane.normal);
    m_tangents << x, y;
}

Eigen::VectorXd StateCoordinates::origin() const {
    const bool freely = m_follow == DirectionsFollow::Freely;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(freely ? 7 : 3);
    if (freely)
        x.tail<4>() << numbersOf(m_start.directions.d1), numbersOf(-m_start.directions.d2);
    return x;
}

Eigen::Vector2d StateCoordinates::numbersOf(const Eigen::Vector3d& d) const {
    if (!(m_reach > 0))
        return Eigen::Vector2d::Zero();
    Eigen::Vector2d u = m_tangents.transpose() * d / std::max(d.dot(m_start.plane.normal), 1e-9) / m_reach;
    // Just inside the rim, so that c stays moderate and the gradient alive.
    const double length = u.norm();
    if (length > kRim)
        u *= kRim / length;
    return u / std::sqrt(1 - u.squaredNorm());
}

MoldState StateCoordinates::state(const Eigen::VectorXd& x) const {
    MoldState s;
    s.plane.normal = (m_start.plane.normal + m_tangents * x.head<2>()).normalized();
    s.plane.offset = m_start.plane.offset + x[2];
    s.directions = m_follow == DirectionsFollow::Held ? m_start.directions : Directions::normalTo(s.plane);
    if (m_follow == DirectionsFollow::Freely) {
        s.directions.d1 = leaning(s.plane.normal, x.segment<2>(3)).normalized();
        s.directions.d2 = -leaning(s.plane.normal, x.segment<2>(5)).normalized();
    }
    return s;
}

void StateCoordinates::pullBack(const Eigen::VectorXd& x, const StateGradient& g,
                                Eigen::VectorXd& gradient) const {
    const Eigen::Vector3d tilted = m_start.plane.normal + m_tangents * x.head<2>();
    const Eigen::Vector3d n = tilted.normalized();
    Eigen::Vector3d gNormal = g.normal;
    gradient.resize(x.size());
    gradient[2] = g.offset;
    if (m_follow == DirectionsFollow::Normal) {
        gNormal += g.d1 - g.d2;
    } else if (m_follow == DirectionsFollow::Freely) {
        gNormal += pullBackLeaning(n, x.segment<2>(3), g.d1, gradient.segment<2>(3));
        gNormal += pullBackLeaning(n, x.segment<2>(5), -g.d2, gradient.segment<2>(5));
    }
    gradient.head<2>() = m_tangents.transpose() * (gNormal - n * n.dot(gNormal)) / tilted.norm();
}

Eigen::Vector3d StateCoordinates::leaning(const Eigen::Vector3d& n, const Eigen::Vector2d& c) const {
    const Eigen::Vector3d w = m_tangents * c;
    return n + m_reach / std::sqrt(1 + c.squaredNorm()) * (w - n * n.dot(w));
}

/// From the gradient g with respect to normalize(leaning(n, c)): writes that with respect to c, returns that
/// with respect to n.
Eigen::Vector3d StateCoordinates::pullBackLeaning(const Eigen::Vector3d& n, const Eigen::Vector2d& c,
                                                  const Eigen::Vector3d& g,
                                                  Eigen::Ref<Eigen::VectorXd> gradientC) const {
    const Eigen::Vector3d u = leaning(n, c);
    const Eigen::Vector3d d = u.normalized();
    const Eigen::Vector3d gu = (g - d * d.dot(g)) / u.norm();
    const double root = std::sqrt(1 + c.squaredNorm());
    const double r = m_reach / root;
    const Eigen::Vector3d w = m_tangents * c;
    const Eigen::Vector2d gw = m_tangents.transpose() * (gu - n * n.dot(gu));
    gradientC = r * gw - c * (r / (root * root) * c.dot(gw));
    return gu * (1 - r * n.dot(w)) - r * w * n.dot(gu);
}

} // namespace moldwright

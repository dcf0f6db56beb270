// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/side_heights.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr double kShare = 0.1;    ///< ε over the height at rest
constexpr double kLargest = 2e-4; ///< ε at most, for a body of size about 1
constexpr double kSmallest = 1e-9;

double height(double u, double epsilon) {
    const double root = std::sqrt(u * u + 4 * epsilon * epsilon);
    // The same number either way; this one does not cancel for u < 0.
    return u > 0 ? (u + root) / 2 : 2 * epsilon * epsilon / (root - u);
}

} // namespace

SideHeights::SideHeights(std::vector<signed char> side, const Positions& rest)
    : m_side(std::move(side)), m_epsilon(m_side.size(), 0) {
    for (std::size_t v = 0; v < m_side.size(); ++v)
        m_epsilon[v] =
            std::clamp(kShare * std::abs(rest(static_cast<Eigen::Index>(v), 2)), kSmallest, kLargest);
}

Positions SideHeights::toFree(Positions X) const {
    for (std::size_t v = 0; v < m_side.size(); ++v) {
        if (m_side[v] == 0)
            continue;
        double& z = X(static_cast<Eigen::Index>(v), 2);
        const double h = std::max(m_side[v] * z, 1e-3 * m_epsilon[v]);
        z = m_side[v] * (h - m_epsilon[v] * m_epsilon[v] / h);
    }
    return X;
}

Positions SideHeights::toPositions(Positions U) const {
    for (std::size_t v = 0; v < m_side.size(); ++v) {
        if (m_side[v] == 0)
            continue;
        double& z = U(static_cast<Eigen::Index>(v), 2);
        z = m_side[v] * height(m_side[v] * z, m_epsilon[v]);
    }
    return U;
}

void SideHeights::pullBack(const Positions& U, Positions& gradient) const {
    for (std::size_t v = 0; v < m_side.size(); ++v) {
        if (m_side[v] == 0)
            continue;
        const double u = m_side[v] * U(static_cast<Eigen::Index>(v), 2);
        const double root = std::sqrt(u * u + 4 * m_epsilon[v] * m_epsilon[v]);
        gradient(static_cast<Eigen::Index>(v), 2) *= height(u, m_epsilon[v]) / root;
    }
}

} // namespace moldwright

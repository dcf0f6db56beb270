// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/draft_cone.h"

#include "castability/mold_state.h"
#include "fill/projected_half.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

// The surface over the sheared plane is P(s) = (s + k·h(s), h(s)), k the run; its normal is (−g, 1 + k·g), g
// the gradient of h, and its product with (k, 1) is 1. So the draft holds where |g|² + (1 + k·g)² is at most
// 1/((1 + k²) sin²): an ellipse about −k/(1 + k²) in the metric 1 + kkᵀ.
DraftCone::DraftCone(const Eigen::Vector2d& run, double draftDegrees) : m_run(run) {
    const double length = 1 + run.squaredNorm();
    const double sine = std::sin(radians(draftDegrees));
    m_tilt = -run / length;
    m_rate = std::sqrt(std::max(1 / (length * sine * sine) - 1 / length, 0.0));
}

double DraftCone::inner(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
    return a.dot(b) - m_run.dot(a) * m_run.dot(b) / (1 + m_run.squaredNorm());
}

double DraftCone::steepness(const Eigen::Vector2d& gradient) const {
    const Eigen::Vector2d g = gradient - m_tilt;
    return std::sqrt(g.squaredNorm() + m_run.dot(g) * m_run.dot(g)) / m_rate;
}

double DraftCone::fall(const Eigen::Vector2d& offset) const {
    return m_rate * std::sqrt(inner(offset, offset)) - m_tilt.dot(offset);
}

double DraftCone::ridge(const Eigen::Vector2d& along, const Eigen::Vector2d& h,
                        const Eigen::Vector2d& offset) const {
    const auto at = [&](double t) { return h[0] + t * (h[1] - h[0]) - fall(offset - t * along); };
    const double squared = inner(along, along);
    if (squared == 0)
        return at(h[1] > h[0] ? 1 : 0);
    const double length = std::sqrt(squared);
    const double slope = (h[1] - h[0] - m_tilt.dot(along)) / (m_rate * length);
    if (std::abs(slope) >= 1)
        return at(slope > 0 ? 1 : 0);
    const double u = inner(offset, along) / length;
    const double beside = std::sqrt(std::max(inner(offset, offset) - u * u, 0.0));
    return at(std::clamp((u + beside * slope / std::sqrt(1 - slope * slope)) / length, 0.0, 1.0));
}

double DraftCone::reach(double drop) const {
    return drop / (m_rate / std::sqrt(1 + m_run.squaredNorm()) - m_tilt.norm());
}

Eigen::Vector2d gradientOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                           const Eigen::Vector3d& heights) {
    const auto turned = [](const Eigen::Vector2d& v) { return Eigen::Vector2d(-v.y(), v.x()); };
    return (heights[0] * turned(c - b) + heights[1] * turned(a - c) + heights[2] * turned(b - a)) /
           doubleArea(a, b, c);
}

} // namespace moldwright

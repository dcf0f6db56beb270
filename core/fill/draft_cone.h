// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace moldwright {

/// How steep the top of a half may be that looks along its direction by a draft angle: of heights over the
/// sheared plane (see ShadowGrid) the gradients allowed form an ellipse, and what leans by exactly the angle
/// on all sides of a point is a cone over it.
class DraftCone {
public:
    /// `run`: how the half's points move in the plane per height as they rise along the direction.
    DraftCone(const Eigen::Vector2d& run, double draftDegrees);

    /// At most 1 for a surface of this gradient that has the draft.
    [[nodiscard]] double steepness(const Eigen::Vector2d& gradient) const;

    /// By how much the cone has come down at `offset` from its tip.
    [[nodiscard]] double fall(const Eigen::Vector2d& offset) const;

    /// Height at `offset` from a ridge's first point of what leans against it on all sides; the ridge runs
    /// from height h[0] to h[1] along `along`.
    [[nodiscard]] double ridge(const Eigen::Vector2d& along, const Eigen::Vector2d& h,
                               const Eigen::Vector2d& offset) const;

    /// How far from a tip of height `drop` above the ground the cone may reach.
    [[nodiscard]] double reach(double drop) const;

private:
    [[nodiscard]] double inner(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;

    Eigen::Vector2d m_run;
    Eigen::Vector2d m_tilt; ///< the ellipse's centre
    double m_rate;          ///< its size
};

/// Gradient of the plane through three points of the plane with heights.
[[nodiscard]] Eigen::Vector2d gradientOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                         const Eigen::Vector2d& c, const Eigen::Vector3d& heights);

} // namespace moldwright

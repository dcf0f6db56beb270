// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <span>

namespace moldwright {

/// A face (v, a, b) of the point v to be placed, and the direction that it is to look along.
struct FaceToPlace {
    Eigen::Vector3d a, b;
    Eigen::Vector3d direction; ///< unit
};

/// Where v may lie, in the plane's frame.
struct PlaceBounds {
    double reach = 0; ///< greatest distance from where it is
    double low = 0;   ///< least and greatest height z
    double high = 0;
};

/// The place for a point, near `start` and within `bounds`, from which the worst of its faces has the most to
/// spare over the draft angle whose sine is `tau`: the most of min_f (c_f·d − τ|c_f|)/|b − a|, c_f the face's
/// area vector. That is concave, so the place found (by the ellipsoid method [Shor 1977]) is the best there
/// is, up to some hundredths of `reach`.
[[nodiscard]] Eigen::Vector3d bestPlace(std::span<const FaceToPlace> faces, const Eigen::Vector3d& start,
                                        const PlaceBounds& bounds, double tau);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "pins/medial_mesh.h"

#include <vector>

namespace moldwright {

/// Balls of `axis` to add to those `chosen` so that no sample is farther than `reach` from every ball: for
/// the sample farthest off the largest ball that reaches it, again and again, `most` at most.
[[nodiscard]] std::vector<MedialBall> missingBalls(const Points& samples, const MedialMesh& axis,
                                                   const std::vector<MedialBall>& chosen, double reach,
                                                   int most);

/// How far p is from a ball's surface: negative inside.
[[nodiscard]] inline double distanceFrom(const MedialBall& ball, const Eigen::Vector3d& p) {
    return (p - ball.centre).norm() - ball.radius;
}

} // namespace moldwright

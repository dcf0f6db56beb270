// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace moldwright {

/// A ball with its centre on the medial axis of a solid: the largest about it that lies inside.
struct MedialBall {
    Eigen::Vector3d centre;
    double radius = 0;
};

/// A medial axis: balls, joined by edges and triangles. Between the balls of an edge or triangle the solid is
/// filled by the balls in between, centres and radii interpolated linearly.
struct MedialMesh {
    std::vector<MedialBall> balls;
    std::vector<std::array<int, 2>> edges; ///< those of the triangles too; smaller index first
    std::vector<std::array<int, 3>> triangles;

    [[nodiscard]] int size() const { return static_cast<int>(balls.size()); }
};

} // namespace moldwright

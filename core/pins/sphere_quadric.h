// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "pins/medial_mesh.h"

#include <Eigen/Core>

namespace moldwright {

/// A ball as a point of ℝ⁴: centre and radius.
using Sphere = Eigen::Vector4d;

[[nodiscard]] inline Sphere sphereOf(const MedialBall& ball) {
    return {ball.centre.x(), ball.centre.y(), ball.centre.z(), ball.radius};
}

/// The sum of squared distances of a ball from planes that it should touch: mᵀAm − 2bᵀm + c. [Li 2015].
struct SphereQuadric {
    Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
    Eigen::Vector4d b = Eigen::Vector4d::Zero();
    double c = 0;

    /// Adds the plane of unit normal n that `touching` touches.
    void add(const Eigen::Vector3d& n, const Sphere& touching, double weight);

    [[nodiscard]] double operator()(const Sphere& m) const { return m.dot(A * m) - 2 * b.dot(m) + c; }

    SphereQuadric& operator+=(const SphereQuadric& o);
};

/// How much of the way between two balls is theirs alone, neither holding the other: 0 for a spike, 1 for a
/// tube.
[[nodiscard]] double stabilityRatio(const Sphere& u, const Sphere& v);

/// For each ball of a medial axis the planes that touch what it and its neighbours fill: two for each
/// triangle, four for each edge without one; weakly, what keeps rims and ends where they are.
[[nodiscard]] std::vector<SphereQuadric> sphereQuadrics(const MedialMesh& axis);

} // namespace moldwright

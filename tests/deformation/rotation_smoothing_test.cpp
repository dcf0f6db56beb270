// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/rotation_smoothing.h"

#include "deformation/tet_topology.h"
#include "support/solids.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

Eigen::Quaterniond anyRotation(int t) {
    const double a = 0.7 * t;
    return Eigen::Quaterniond(1 + std::cos(a), std::sin(a), std::cos(2 * a), std::sin(3 * a)).normalized();
}

} // namespace

TEST(RotationSmoothing, BlendsEachTetWithTheMeanOfItsNeighbours) {
    const test::Solid solid = test::solidBox({0, 0, 0}, {1.5, 1, 0.8}, {3, 2, 2});
    const ElasticBody body({solid.tets.V, solid.tets.T, solid.F, {}, 0.5, 0});
    const auto neighbours = tetNeighbours(solid.tets.T);
    Rotations from;
    body.fit(solid.tets.V, from);
    for (int t = 0; t < body.tetCount(); ++t)
        setRotation(from, body.laneOf(t), anyRotation(t));
    Rotations to;
    const double gamma = 0.3;
    RotationSmoothing(body, neighbours).apply(from, gamma, to);
    for (int t = 0; t < body.tetCount(); ++t) {
        const Eigen::Vector4d own = anyRotation(t).coeffs();
        Eigen::Vector4d sum = Eigen::Vector4d::Zero();
        int count = 0;
        for (const int u : neighbours[static_cast<std::size_t>(t)]) {
            if (u < 0)
                continue;
            const Eigen::Vector4d other = anyRotation(u).coeffs();
            sum += other.dot(own) < 0 ? Eigen::Vector4d(-other) : other;
            ++count;
        }
        ASSERT_GT(count, 0);
        const Eigen::Vector4d wanted = ((1 - gamma) * own + gamma / count * sum).normalized();
        EXPECT_LT((rotationAt(to, body.laneOf(t)).coeffs() - wanted).norm(), 1e-12) << t;
    }
    const int face = body.laneOf(body.tetCount());
    EXPECT_LT((rotationAt(to, face).coeffs() - rotationAt(from, face).coeffs()).norm(), 1e-15);
}

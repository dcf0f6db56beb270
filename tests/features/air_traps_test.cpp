// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/air_traps.h"

#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace moldwright;
using Eigen::Vector3d;

namespace {

/// The point of the mesh that is highest along `up`.
int highest(const IndexedMesh& mesh, const Vector3d& up) {
    Eigen::Index at = 0;
    (mesh.V * up).maxCoeff(&at);
    return static_cast<int>(at);
}

/// A bar along x with two towers of the given heights, seen in its xy plane; all 2 mm thick.
IndexedMesh twoTowers(double left, double right) {
    const std::vector<Eigen::Vector2d> outline = {{0, 0}, {10, 0}, {10, 2 + right}, {8, 2 + right},
                                                  {8, 2}, {2, 2},  {2, 2 + left},   {0, 2 + left}};
    IndexedMesh mesh;
    mesh.V.resize(16, 3);
    for (int k = 0; k < 8; ++k) {
        mesh.V.row(k) << outline[static_cast<std::size_t>(k)].transpose(), -1;
        mesh.V.row(k + 8) << outline[static_cast<std::size_t>(k)].transpose(), 1;
    }
    const std::vector<Eigen::RowVector3i> lid = {{0, 1, 4}, {1, 2, 3}, {1, 3, 4},
                                                 {0, 4, 5}, {0, 5, 7}, {5, 6, 7}};
    mesh.F.resize(28, 3);
    int f = 0;
    for (const Eigen::RowVector3i& t : lid) {
        mesh.F.row(f++) << t[0], t[2], t[1];
        mesh.F.row(f++) << t[0] + 8, t[1] + 8, t[2] + 8;
    }
    for (int k = 0; k < 8; ++k) {
        const int next = (k + 1) % 8;
        mesh.F.row(f++) << k, next, next + 8;
        mesh.F.row(f++) << k, next + 8, k + 8;
    }
    return test::splitInFour(test::splitInFour(mesh));
}

} // namespace

TEST(AirTraps, OfATowerBesideTheSpoutIsItsVolume) {
    const IndexedMesh part = twoTowers(3, 5);
    ASSERT_NEAR(volume(part), 20 * 2 + 2 * 3 * 2 + 2 * 5 * 2, 1e-9);
    const Vector3d up = Vector3d::UnitY();
    const std::vector<AirTrap> traps = airTraps(part, up, highest(part, up), 0.5);
    ASSERT_EQ(traps.size(), 1U);
    EXPECT_NEAR(traps[0].volume, 2 * 3 * 2, 1e-9);
    EXPECT_NEAR(traps[0].level, 2, 1e-12);
    EXPECT_NEAR(part.point(traps[0].point).y(), 5, 1e-12);
    EXPECT_NEAR(airAbove(part, up, traps[0], 4), 2 * 1 * 2, 1e-9);
}

TEST(AirTraps, AboveTheSpoutAirStaysToo) {
    const IndexedMesh ball = test::sphere({0, 0, 0}, 10, 4);
    const Vector3d up = Vector3d::UnitY();
    // Drained half way up: the cap above is trapped.
    int drain = 0;
    for (int v = 0; v < ball.vertexCount(); ++v)
        if (std::abs(ball.V(v, 1) - 5) < std::abs(ball.V(drain, 1) - 5))
            drain = v;
    const std::vector<AirTrap> traps = airTraps(ball, up, drain, 1);
    ASSERT_EQ(traps.size(), 1U);
    const double h = 10 - ball.V(drain, 1);
    EXPECT_NEAR(traps[0].volume, std::numbers::pi * h * h * (10 - h / 3), 0.02 * traps[0].volume);
    EXPECT_TRUE(airTraps(ball, up, highest(ball, up), 0.01).empty());
}

TEST(AirTraps, SmallOnesAreLeftOut) {
    const IndexedMesh part = twoTowers(3, 5);
    const Vector3d up = Vector3d::UnitY();
    EXPECT_TRUE(airTraps(part, up, highest(part, up), 12.5).empty());
}

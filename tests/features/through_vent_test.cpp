// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/through_vent.h"

#include "castability/certificate.h"
#include "features/joined_channel.h"
#include "mesh/measures.h"
#include "support/casts.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector3d;

namespace {

constexpr double grid = 1.0 / 65536;
const ThroughVentRequest usual{1.5, 16, 1.5, grid};

} // namespace

TEST(ThroughVent, NarrowsOutwardsAndLeavesTheCastCastable) {
    for (const int side : {1, 2}) {
        const KnownCast cast = sheared(ball(12, 4), 0.3, -0.35);
        const SideLabels labels = labelSides(cast.mesh, {});
        const Vector3d high(0.3 * 4, 10, side == 1 ? 4 : -4);
        const auto vent =
            ThroughVents(cast.mesh, labels, cast.state.directions).from(side, high, Vector3d::UnitY(), usual);
        ASSERT_TRUE(vent);
        const IndexedMesh solid = vent->solid();
        EXPECT_EQ(side == 1 ? boundingBox(solid).max().z() : -boundingBox(solid).min().z(), 16);
        // The foot is wider than the mouth by the draft over the length.
        const auto width = [](const PlanShape& shape) {
            double least = 1e300;
            double most = -1e300;
            for (const Eigen::Vector2d& p : shape) {
                least = std::min(least, p.y());
                most = std::max(most, p.y());
            }
            return most - least;
        };
        const double length = 16 - vent->foot;
        EXPECT_GE(width(vent->body.base),
                  width(vent->body.lid[side == 1 ? 0 : 1]) + 2 * length * std::tan(radians(1.4)));
        const auto joined = joinedSolid(cast.mesh, {solid}, {cast.state.directions, 1, grid, {}});
        ASSERT_TRUE(joined);
        EXPECT_TRUE(certify(*joined, labelSides(*joined, {}), {{}, cast.state.directions}, 1).holds());
        EXPECT_LE(vent->reach, 12);
        EXPECT_GT(vent->reach, 7) << "near to the high point";
    }
}

TEST(ThroughVent, IsNoneInASlenderCast) {
    const KnownCast cast = frusta(20, 1, 3, 3, 0.02);
    const SideLabels labels = labelSides(cast.mesh, {});
    EXPECT_FALSE(ThroughVents(cast.mesh, labels, {}).from(1, {0, 0.5, 2}, Vector3d::UnitY(), usual));
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/opposite_sides.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;

TEST(OppositeSides, TellClosedSurfacesFromOthers) {
    IndexedMesh ball = test::sphere({0, 0, 0}, 1, 2);
    EXPECT_TRUE(closedManifold(ball.F, ball.vertexCount()));
    const OppositeSides opposite = oppositeSides(ball.F, ball.vertexCount());
    for (int s = 0; s < static_cast<int>(opposite.of.size()); ++s) {
        const int back = opposite.of[static_cast<std::size_t>(s)];
        ASSERT_GE(back, 0);
        EXPECT_EQ(ball.F(s / 3, s % 3), ball.F(back / 3, (back % 3 + 1) % 3));
    }
    IndexedMesh open = ball;
    open.F.conservativeResize(ball.faceCount() - 1, 3);
    EXPECT_FALSE(closedManifold(open.F, open.vertexCount()));
    // Two balls that share a point.
    IndexedMesh pair = test::together(ball, test::sphere({2, 0, 0}, 1, 2));
    EXPECT_TRUE(closedManifold(pair.F, pair.vertexCount()));
    pair.F = pair.F.unaryExpr([&](int v) { return v == ball.vertexCount() ? 0 : v; });
    EXPECT_FALSE(closedManifold(pair.F, pair.vertexCount()));
}

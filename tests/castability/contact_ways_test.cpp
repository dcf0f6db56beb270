// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/contact_ways.h"

#include "castability/mold_state.h"
#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;
using Eigen::Vector3d;

namespace {

/// Twice as wide below as above: castable from the level plane at its lower face up.
IndexedMesh frustum() {
    IndexedMesh mesh = test::box({-2, -2, 0}, {2, 2, 2});
    for (int v = 0; v < mesh.vertexCount(); ++v)
        if (mesh.V(v, 2) > 1)
            mesh.V.row(v).head<2>() /= 2;
    return mesh;
}

/// What is left of a block around the shape, as a solid with a hollow.
IndexedMesh halfAround(const IndexedMesh& shape) {
    IndexedMesh hollow = shape;
    hollow.F.col(1).swap(hollow.F.col(2));
    return test::together(test::box({-9, -9, 0}, {9, 9, 9}), hollow);
}

Points middlesOf(const IndexedMesh& mesh) {
    Points middles(mesh.faceCount(), 3);
    for (int f = 0; f < mesh.faceCount(); ++f)
        middles.row(f) = (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)).transpose() / 3;
    return middles;
}

ContactWays waysFrom(const IndexedMesh& shape, const Vector3d& d) {
    return contactWays(middlesOf(shape), halfAround(shape), d);
}

} // namespace

TEST(ContactWays, ACastableShapeIsNeverMet) {
    EXPECT_FALSE(waysFrom(frustum(), Vector3d::UnitZ()).any());
}

TEST(ContactWays, WhatHangsOverIsMetUntilTheHalfIsPast) {
    // 1 mm of the half lies below the box: it meets the underside at once, and the top when it has come
    // there.
    const IndexedMesh shape = test::box({-2, -2, 1}, {2, 2, 3});
    const ContactWays ways = waysFrom(shape, Vector3d::UnitZ());
    EXPECT_TRUE(ways.any());
    for (int f = 0; f < shape.faceCount(); ++f) {
        const double z = middlesOf(shape)(f, 2);
        if (z != 1 && z != 3)
            continue; // walls are met at an edge: nothing is said of them
        for (const double way : {0.1, 0.9, 1.1, 1.9, 2.1, 2.9, 3.1, 50.0}) {
            const bool meets = z == 1 ? way < 1 : way > 2 && way < 3;
            EXPECT_EQ(ways.touches(static_cast<std::size_t>(f), way), meets) << z << ' ' << way;
        }
    }
}

TEST(ContactWays, DirectionsDecide) {
    // Its walls lean by 26.6°: along a direction that leans by 40° one of them is in the way.
    const IndexedMesh shape = frustum();
    const Vector3d leaning(std::sin(radians(40)), 0, std::cos(radians(40)));
    const ContactWays ways = waysFrom(shape, leaning);
    int met = 0;
    for (int f = 0; f < shape.faceCount(); ++f) {
        const bool inTheWay = doubleAreaVector(shape, f).dot(leaning) < 0 && middlesOf(shape)(f, 2) > 0;
        EXPECT_EQ(ways.touches(static_cast<std::size_t>(f), 0.2), inTheWay) << f;
        met += inTheWay ? 1 : 0;
    }
    EXPECT_EQ(met, 2);
}

TEST(ContactWays, AHalfThatOnlyTouchesMeetsNothing) {
    const IndexedMesh shape = frustum();
    IndexedMesh half = halfAround(shape);
    // Rounded as files round, and a little aside.
    half.V = half.V.cast<float>().cast<double>();
    half.V.array() += 3e-6;
    EXPECT_FALSE(contactWays(middlesOf(shape), half, Vector3d::UnitZ()).any());
}

TEST(ContactWays, OfNothingTouchNothing) {
    EXPECT_FALSE(ContactWays().any());
    EXPECT_FALSE(ContactWays().touches(0, 1));
}

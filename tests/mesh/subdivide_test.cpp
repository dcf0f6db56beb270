// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/subdivide.h"

#include "mesh/check.h"
#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace moldwright;

TEST(Subdivide, EachRoundMakesFourFacesOfOneAndKeepsTheTopology) {
    const IndexedMesh torus = test::torus(3, 1, 24, 12);
    const IndexedMesh fine = subdivide(torus, 2);
    EXPECT_EQ(fine.faceCount(), 16 * torus.faceCount());
    const MeshDiagnosis diagnosis = diagnose(fine);
    EXPECT_TRUE(diagnosis.usable());
    EXPECT_EQ(diagnosis.genus, 1);
    EXPECT_EQ(diagnosis.components, 1);
}

/// At a point of the octahedron, valence 4, Loop's rule keeps 1 − 4β of the point and adds β of each
/// neighbour, with β = (5/8 − (3/8 + cos(2π/4)/4)²)/4 = 31/256; the four neighbours cancel.
TEST(Subdivide, PointsMoveByLoopsRule) {
    const IndexedMesh octahedron = test::sphere({0, 0, 0}, 1, 0);
    const IndexedMesh fine = subdivide(octahedron, 1);
    for (int v = 0; v < octahedron.vertexCount(); ++v)
        EXPECT_TRUE(fine.point(v).isApprox((1 - 4 * 31.0 / 256) * octahedron.point(v), 1e-12)) << v;
}

/// An edge's new point: 3/8 of each end, 1/8 of each opposite corner; of the octahedron's these cancel.
TEST(Subdivide, EdgesGetTheirPointByLoopsRule) {
    const IndexedMesh fine = subdivide(test::sphere({0, 0, 0}, 1, 0), 1);
    ASSERT_EQ(fine.vertexCount(), 6 + 12);
    for (int v = 6; v < fine.vertexCount(); ++v) {
        EXPECT_NEAR(fine.point(v).cwiseAbs().maxCoeff(), 3.0 / 8, 1e-12) << v;
        EXPECT_NEAR(fine.point(v).norm(), 3.0 / 8 * std::sqrt(2.0), 1e-12) << v;
    }
}

TEST(Subdivide, ABoxBecomesRounderAndSmaller) {
    const IndexedMesh box = test::splitInFour(test::box({-1, -1, -1}, {1, 1, 1}));
    const IndexedMesh once = subdivide(box, 1);
    const IndexedMesh twice = subdivide(box, 2);
    EXPECT_LT(volume(once), volume(box));
    EXPECT_LT(volume(twice), volume(once));
    EXPECT_GT(volume(twice), 0.5 * volume(box));
}

TEST(Subdivide, APointMayHaveManyNeighbours) {
    const int sides = 80;
    IndexedMesh spindle;
    spindle.V.resize(sides + 2, 3);
    Triangles upper(sides, 3);
    Triangles lower(sides, 3);
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        spindle.V.row(i) << std::cos(angle), std::sin(angle), 0;
        upper.row(i) << i, (i + 1) % sides, sides;
        lower.row(i) << (i + 1) % sides, i, sides + 1;
    }
    spindle.F.resize(upper.rows() + lower.rows(), 3);
    spindle.F << upper, lower;
    spindle.V.row(sides) << 0, 0, 1;
    spindle.V.row(sides + 1) << 0, 0, -1;
    // 1 − α of the tip stays, its neighbours lie at height 0.
    const double alpha = 5.0 / 8 - std::pow(3.0 / 8 + std::cos(2 * std::numbers::pi / sides) / 4, 2);
    EXPECT_NEAR(subdivide(spindle, 1).V(sides, 2), 1 - alpha, 1e-12);
}

TEST(Subdivide, NoRoundsChangeNothing) {
    const IndexedMesh sphere = test::sphere({1, 2, 3}, 2, 2);
    EXPECT_EQ(subdivide(sphere, 0).V, sphere.V);
    EXPECT_EQ(subdivide(sphere, 0).F, sphere.F);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geodesic_disc.h"

#include "support/shapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace moldwright;
using Eigen::Vector3d;

namespace {

Vector3d middleOf(const IndexedMesh& mesh, int f) {
    return (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
}

SurfacePlace placeIn(const IndexedMesh& mesh, int f) {
    return {f, middleOf(mesh, f)};
}

/// A sheet of long triangles, sheared so that most of them are obtuse, bent by `bend` (point → point).
template <class Bend>
IndexedMesh sheet(int across, int along, Bend bend) {
    IndexedMesh mesh{Points((across + 1) * (along + 1), 3), Triangles(2 * across * along, 3)};
    for (int i = 0; i <= across; ++i)
        for (int j = 0; j <= along; ++j)
            mesh.V.row(i * (along + 1) + j) = bend(Vector3d(i + 1.7 * j, 0.4 * j, 0)).transpose();
    for (int i = 0; i < across; ++i)
        for (int j = 0; j < along; ++j) {
            const int v = i * (along + 1) + j;
            mesh.F.row(2 * (i * along + j)) << v, v + along + 1, v + along + 2;
            mesh.F.row(2 * (i * along + j) + 1) << v, v + along + 2, v + 1;
        }
    return mesh;
}

FaceNeighbours neighboursOf(const IndexedMesh& mesh) {
    return FaceNeighbours(std::make_shared<const IndexedMesh>(mesh));
}

/// A sheet bent to a hairpin: two walls 0.2 apart, joined along one edge only.
IndexedMesh hairpin() {
    return sheet(60, 60, [](const Vector3d& p) {
        const double way = 20 * p.y();
        return way < 240 ? Vector3d(p.x() - 4.25 * p.y(), way, 0)
                         : Vector3d(p.x() - 4.25 * p.y(), 480 - way, 0.2);
    });
}

} // namespace

TEST(GeodesicDistances, InAPlaneAreThoseOfARulerWhateverTheTriangles) {
    const IndexedMesh flat = sheet(40, 40, [](const Vector3d& p) { return p; });
    const SurfacePlace from = placeIn(flat, flat.faceCount() / 2 + 40);
    const std::vector<double> distance = geodesicDistances(neighboursOf(flat), from, 10);
    int within = 0;
    for (int v = 0; v < flat.vertexCount(); ++v) {
        const double ruler = (flat.point(v) - from.point).norm();
        if (ruler > 5)
            continue;
        ++within;
        EXPECT_GE(distance[static_cast<std::size_t>(v)], ruler - 1e-9);
        EXPECT_LE(distance[static_cast<std::size_t>(v)], 1.0001 * ruler);
    }
    EXPECT_GT(within, 100);
}

TEST(GeodesicDistances, OnABallFollowItsGreatCircles) {
    const IndexedMesh ball = test::sphere(Vector3d::Zero(), 10, 5);
    const SurfacePlace from = placeIn(ball, 1234);
    const std::vector<double> distance = geodesicDistances(neighboursOf(ball), from, 40);
    for (int v = 0; v < ball.vertexCount(); ++v) {
        const double angle =
            std::atan2(from.point.cross(ball.point(v)).norm(), from.point.dot(ball.point(v)));
        EXPECT_NEAR(distance[static_cast<std::size_t>(v)], 10 * angle, 0.01 * 10 * angle + 0.02);
    }
}

TEST(GeodesicDisc, IsRoundAndHasTheAreaOfACircle) {
    const IndexedMesh flat = sheet(60, 60, [](const Vector3d& p) { return p; });
    const int f = flat.faceCount() / 2 + 60;
    const std::vector<int> disc = geodesicDisc(neighboursOf(flat), placeIn(flat, f), 6);
    const double area = 0.2 * static_cast<double>(disc.size()); // each triangle is 1 long and 0.4 high
    EXPECT_NEAR(area, std::numbers::pi * 36, 1.5);
    for (const int in : disc)
        EXPECT_LE((middleOf(flat, in) - middleOf(flat, f)).norm(), 6 + 1e-9);
}

TEST(GeodesicDisc, DoesNotJumpToASheetThatIsNearThroughTheAir) {
    const IndexedMesh pin = hairpin();
    const int f = 2 * 30 * 60 + 2 * 10;
    const std::vector<int> disc = geodesicDisc(neighboursOf(pin), placeIn(pin, f), 30);
    ASSERT_GT(disc.size(), 10U);
    for (const int in : disc)
        EXPECT_LT(middleOf(pin, in).z(), 0.1);
    // But it goes round the bend.
    const int atBend = 2 * 30 * 60 + 2 * 29;
    const std::vector<int> round = geodesicDisc(neighboursOf(pin), placeIn(pin, atBend), 30);
    EXPECT_TRUE(std::ranges::any_of(round, [&](int in) { return middleOf(pin, in).z() > 0.1; }));
}

TEST(GeodesicDisc, HasAtLeastTheFaceItStandsOn) {
    const IndexedMesh box = test::box(Vector3d::Zero(), Vector3d::Constant(10));
    EXPECT_EQ(geodesicDisc(neighboursOf(box), placeIn(box, 5), 0.01), std::vector({5}));
    EXPECT_EQ(geodesicDisc(neighboursOf(box), placeIn(box, 5), 100).size(), 12U);
}

TEST(GeodesicDisc, TakesWideFacesWhoseMiddleIsNearThoughTheirCornersAreNot) {
    const IndexedMesh box = test::box(Vector3d::Zero(), Vector3d::Constant(10));
    // The middle of a wall's diagonal: both of its faces have their middles 2.36 away, corners 7.07.
    const FaceNeighbours neighbours = neighboursOf(box);
    const Vector3d a = (box.corner(0, 0) + box.corner(0, 1)) / 2;
    const Vector3d b = (box.corner(0, 1) + box.corner(0, 2)) / 2;
    const Vector3d c = (box.corner(0, 2) + box.corner(0, 0)) / 2;
    const Vector3d wall(5, 5, 5);
    Vector3d middle = a;
    for (const Vector3d& side : {b, c})
        if ((side - wall).norm() < (middle - wall).norm())
            middle = side;
    EXPECT_EQ(geodesicDisc(neighbours, {0, middle}, 3).size(), 2U);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/polygon_soup.h"

#include "mesh/measures.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

using namespace moldwright;

namespace {

PolygonSoup onePolygon(const std::vector<Eigen::Vector3d>& ring) {
    PolygonSoup soup;
    soup.points = ring;
    for (std::size_t i = 0; i < ring.size(); ++i)
        soup.corners.push_back(static_cast<int>(i));
    soup.endPolygon();
    return soup;
}

/// Twice the area vector of the whole polygon.
Eigen::Vector3d areaOf(const std::vector<Eigen::Vector3d>& ring) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < ring.size(); ++i)
        sum += ring[i].cross(ring[(i + 1) % ring.size()]);
    return sum;
}

} // namespace

TEST(PolygonSoup, CornersOfAPolygonThatNeverEndedMakeNoFaces) {
    PolygonSoup soup = onePolygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    soup.corners.insert(soup.corners.end(), {0, 1, 2, 1});
    EXPECT_EQ(triangulated(soup).faceCount(), 1);
}

TEST(PolygonSoup, TrianglesStayAsTheyAre) {
    const IndexedMesh mesh = triangulated(onePolygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    ASSERT_EQ(mesh.faceCount(), 1);
    EXPECT_EQ(mesh.F.row(0), Eigen::RowVector3i(0, 1, 2));
}

TEST(PolygonSoup, AHollowCornerIsNotCutAcross) {
    // An arrow head: only the cut from its hollow corner 3 stays inside.
    const IndexedMesh mesh = triangulated(onePolygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 1, 0}}));
    ASSERT_EQ(mesh.faceCount(), 2);
    for (int f = 0; f < 2; ++f)
        EXPECT_GT(doubleAreaVector(mesh, f).z(), 0);
}

// A star-shaped polygon of random radii in a random plane at a random scale: every triangle has the polygon's
// side up, and together they have its area.
RC_GTEST_PROP(PolygonSoup, TrianglesFillThePolygonOnce, ()) {
    const auto radii = *rc::gen::container<std::vector<int>>(*rc::gen::inRange<std::size_t>(4, 40),
                                                             rc::gen::inRange(1, 100));
    const int turn = *rc::gen::inRange(0, 100);
    const double scale = std::pow(10.0, *rc::gen::inRange(-30, 30));
    const Eigen::AngleAxisd rotation(0.06 * turn, Eigen::Vector3d(1, 2, turn - 50).normalized());
    std::vector<Eigen::Vector3d> ring;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        const double angle =
            2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(radii.size());
        ring.emplace_back(rotation *
                          (Eigen::Vector3d(std::cos(angle), std::sin(angle), 0) * radii[i] * scale));
    }
    const IndexedMesh mesh = triangulated(onePolygon(ring));
    RC_ASSERT(mesh.faceCount() == static_cast<int>(ring.size()) - 2);
    const Eigen::Vector3d whole = areaOf(ring);
    double sum = 0;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        RC_ASSERT(doubleAreaVector(mesh, f).dot(whole) > -1e-12 * whole.squaredNorm());
        sum += doubleAreaVector(mesh, f).norm();
    }
    RC_ASSERT(std::abs(sum - whole.norm()) < 1e-9 * whole.norm());
}

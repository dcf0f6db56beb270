// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/fault_places.h"

#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace moldwright;

namespace {

IndexedMesh without(IndexedMesh mesh, const std::vector<int>& missing) {
    std::vector<int> kept;
    for (int f = 0; f < mesh.faceCount(); ++f)
        if (std::ranges::find(missing, f) == missing.end())
            kept.push_back(f);
    mesh.F = mesh.F(kept, Eigen::all).eval();
    return mesh;
}

std::vector<FaultPlace> placesOf(const IndexedMesh& mesh) {
    return faultPlaces(examine(mesh, "part.stl"));
}

} // namespace

TEST(FaultPlaces, ASoundMeshHasNone) {
    EXPECT_TRUE(placesOf(test::sphere({0, 0, 0}, 5, 2)).empty());
}

TEST(FaultPlaces, EveryHoleIsOneWithItsOpenEdgesTheWidestFirst) {
    // A triangle is missing at one end, and two neighbours that are wider at the other.
    const IndexedMesh box = test::together(test::box({0, 0, 0}, {10, 1, 1}), test::sphere({30, 0, 0}, 5, 2));
    const std::vector<FaultPlace> places = placesOf(without(box, {12, 0, 1}));
    ASSERT_EQ(places.size(), 2U);
    for (const FaultPlace& place : places)
        EXPECT_EQ(place.kind, FaultKind::Hole);
    EXPECT_EQ(places[0].edges.size(), 4U);
    EXPECT_EQ(places[1].edges.size(), 3U);
    EXPECT_EQ(places[1].faces.size(), 3U);
    EXPECT_GT(places[0].box.diagonal().norm(), places[1].box.diagonal().norm());
    EXPECT_LT(places[0].box.max().x(), 11);
    EXPECT_GT(places[1].box.min().x(), 20);
}

TEST(FaultPlaces, TwoBoxesThatShareAnEdgeAreAtFaultThereOnly) {
    IndexedMesh both = test::together(test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 0}, {2, 2, 1}));
    const std::vector<FaultPlace> places = placesOf(both);
    ASSERT_FALSE(places.empty());
    EXPECT_EQ(places[0].kind, FaultKind::CrowdedEdge);
    ASSERT_EQ(places[0].edges.size(), 1U);
    EXPECT_EQ(places[0].faces.size(), 4U);
    EXPECT_EQ(places[0].box.min(), Eigen::Vector3d(1, 1, 0));
    EXPECT_EQ(places[0].box.max(), Eigen::Vector3d(1, 1, 1));
}

TEST(FaultPlaces, BoxesThatTouchInACornerArePinchedThere) {
    const std::vector<FaultPlace> places =
        placesOf(test::together(test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 1}, {2, 2, 2})));
    ASSERT_FALSE(places.empty());
    EXPECT_EQ(places[0].kind, FaultKind::PinchedPoint);
    EXPECT_TRUE(places[0].box.contains(Eigen::Vector3d(1, 1, 1)));
    EXPECT_EQ(std::ranges::count(places, FaultKind::PinchedPoint, &FaultPlace::kind), 1);
}

TEST(FaultPlaces, SpheresThatCrossDoSoInOnePlaceEach) {
    const IndexedMesh row =
        test::together(test::together(test::sphere({0, 0, 0}, 5, 3), test::sphere({9, 0, 0}, 5, 3)),
                       test::sphere({17, 0, 0}, 4, 3));
    const std::vector<FaultPlace> places = placesOf(row);
    ASSERT_EQ(places.size(), 2U);
    for (const FaultPlace& place : places) {
        EXPECT_EQ(place.kind, FaultKind::Crossing);
        EXPECT_TRUE(std::ranges::is_sorted(place.faces));
        EXPECT_EQ(std::ranges::adjacent_find(place.faces), place.faces.end());
        EXPECT_LT(place.box.sizes().x(), 4);
    }
}

TEST(FaultPlaces, AnEnclosedSurfaceIsItsOwnFaces) {
    const IndexedMesh outer = test::sphere({0, 0, 0}, 5, 2);
    const IndexedMesh inner = test::sphere({1, 0, 0}, 2, 1);
    const std::vector<FaultPlace> places = placesOf(test::together(outer, inner));
    ASSERT_EQ(places.size(), 1U);
    EXPECT_EQ(places[0].kind, FaultKind::Enclosed);
    EXPECT_EQ(places[0].faces.size(), static_cast<std::size_t>(inner.faceCount()));
    EXPECT_EQ(places[0].faces.front(), outer.faceCount());
}

TEST(FaultPlaces, AFaceWithoutAreaIsSeenByItsEdges) {
    // A point in the middle of an edge of one face only: what closes the gap has no area.
    IndexedMesh box = test::box({0, 0, 0}, {1, 1, 1});
    const int a = box.F(0, 0);
    const int b = box.F(0, 1);
    const int c = box.F(0, 2);
    const int middle = box.vertexCount();
    box.V.conservativeResize(middle + 1, 3);
    box.V.row(middle) = (box.V.row(a) + box.V.row(b)) / 2;
    const int m = box.faceCount();
    box.F.conservativeResize(m + 2, 3);
    box.F.row(0) << a, middle, c;
    box.F.row(m) << middle, b, c;
    box.F.row(m + 1) << a, b, middle;
    const std::vector<FaultPlace> places = placesOf(box);
    ASSERT_EQ(places.size(), 2U);
    EXPECT_EQ(places[0].kind, FaultKind::FaceWithoutArea);
    EXPECT_EQ(places[0].faces, std::vector{m + 1});
    EXPECT_EQ(places[0].edges.size(), 3U);
    EXPECT_EQ(places[1].kind, FaultKind::Crossing) << "its neighbours touch at the point in the middle";
}

TEST(FaultPlaces, AMeshRefusedForItsSizeIsNotSearched) {
    IndexedMesh huge = without(test::box({0, 0, 0}, {1, 1, 1}), {0});
    huge.V *= 1e60;
    EXPECT_TRUE(placesOf(huge).empty());
}

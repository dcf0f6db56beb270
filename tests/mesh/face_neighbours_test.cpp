// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/face_neighbours.h"

#include "mesh/edge_table.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace moldwright;
using Eigen::Vector3d;

namespace {

SharedMesh shared(const IndexedMesh& mesh) {
    return std::make_shared<const IndexedMesh>(mesh);
}

} // namespace

TEST(FaceNeighbours, KnowTheFacesAboutPointsAndBeyondSides) {
    const SharedMesh ball = shared(test::sphere(Vector3d::Zero(), 5, 3));
    const FaceNeighbours neighbours(ball);
    for (int v = 0; v < ball->vertexCount(); ++v) {
        std::vector<int> expected;
        for (int f = 0; f < ball->faceCount(); ++f)
            if ((ball->F.row(f).array() == v).any())
                expected.push_back(f);
        EXPECT_TRUE(std::ranges::equal(neighbours.around(v), expected));
    }
    const EdgeTable edges(ball->F);
    for (int e = 0; e < edges.edgeCount(); ++e) {
        const auto sides = edges.sidesAt(e);
        ASSERT_EQ(sides.size(), 2U);
        EXPECT_EQ(neighbours.across(sides[0].face, sides[0].corner), sides[1].face);
        EXPECT_EQ(neighbours.across(sides[1].face, sides[1].corner), sides[0].face);
    }
}

TEST(FaceNeighbours, BeyondABorderThereIsNoFace) {
    const IndexedMesh one{Points::Random(3, 3), (Triangles(1, 3) << 0, 1, 2).finished()};
    EXPECT_EQ(FaceNeighbours(shared(one)).across(0, 1), -1);
}

TEST(SmoothPatch, EndsAtCreasesOrWithThePiece) {
    IndexedMesh box = test::splitInFour(test::splitInFour(test::box(Vector3d::Zero(), {4, 5, 6})));
    const int faces = box.faceCount();
    const FaceNeighbours neighbours(shared(test::together(box, test::box({9, 9, 9}, {10, 10, 10}))));
    const std::vector<int> wall = smoothPatch(neighbours, 7, 30);
    EXPECT_EQ(static_cast<int>(wall.size()), faces / 6) << "one of six walls";
    EXPECT_TRUE(std::ranges::is_sorted(wall));
    EXPECT_EQ(static_cast<int>(smoothPatch(neighbours, 7, 91).size()), faces) << "over the edges too";
    EXPECT_EQ(static_cast<int>(smoothPatch(neighbours, 7, 180).size()), faces) << "not the other box";
    EXPECT_EQ(static_cast<int>(smoothPatch(neighbours, faces, 180).size()), 12);
}

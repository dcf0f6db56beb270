// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/finer_faces.h"

#include "mesh/check.h"
#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace moldwright;
using namespace moldwright::test;

namespace {

double longestEdgeOf(const IndexedMesh& mesh, int f) {
    double longest = 0;
    for (int k = 0; k < 3; ++k)
        longest = std::max(longest, (mesh.corner(f, (k + 1) % 3) - mesh.corner(f, k)).norm());
    return longest;
}

} // namespace

TEST(FinerFaces, AreShortAndOfTheSameShape) {
    const IndexedMesh long1 = box({0, 0, 0}, {40, 3, 7});
    const FinerMesh finer = withFinerFaces(long1, std::vector<char>(12, 1), 2);
    EXPECT_TRUE(diagnose(finer.mesh).usable()) << "closed, oriented, no face crosses another";
    EXPECT_NEAR(volume(finer.mesh), 40 * 3 * 7, 1e-9);
    EXPECT_NEAR(surfaceArea(finer.mesh), 2 * (40 * 3 + 40 * 7 + 3 * 7), 1e-9);
    ASSERT_EQ(finer.from.size(), static_cast<std::size_t>(finer.mesh.faceCount()));
    for (int f = 0; f < finer.mesh.faceCount(); ++f) {
        EXPECT_LE(longestEdgeOf(finer.mesh, f), 2);
        const Eigen::Vector3d normal = doubleAreaVector(finer.mesh, f).normalized();
        const Eigen::Vector3d before = doubleAreaVector(long1, finer.from[static_cast<std::size_t>(f)]);
        EXPECT_NEAR(normal.dot(before.normalized()), 1, 1e-12);
    }
}

TEST(FinerFaces, LeaveOthersButForTheirBorders) {
    const IndexedMesh cube = box({0, 0, 0}, {10, 10, 10});
    std::vector<char> wanted(12, 0);
    wanted[0] = 1;
    const FinerMesh finer = withFinerFaces(cube, wanted, 3);
    EXPECT_TRUE(diagnose(finer.mesh).usable());
    for (int f = 0; f < finer.mesh.faceCount(); ++f)
        if (finer.from[static_cast<std::size_t>(f)] == 0) {
            EXPECT_LE(longestEdgeOf(finer.mesh, f), 3);
        }
    const auto partsOf = [&](int face) { return std::ranges::count(finer.from, face); };
    EXPECT_GT(partsOf(0), 16);
    int whole = 0;
    for (int face = 1; face < 12; ++face)
        whole += partsOf(face) == 1 ? 1 : 0;
    EXPECT_EQ(whole, 8) << "three faces border the one that is cut";
    EXPECT_EQ(finer.mesh.V.topRows(8), cube.V) << "points keep their numbers";
}

TEST(FinerFaces, ThatAreShortStayAsTheyAre) {
    const IndexedMesh round = sphere({1, 2, 3}, 5, 3);
    const FinerMesh finer = withFinerFaces(round, std::vector<char>(round.F.rows(), 1), 5);
    EXPECT_EQ(finer.mesh.F, round.F);
}

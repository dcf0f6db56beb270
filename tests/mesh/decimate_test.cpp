// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/decimate.h"

#include "mesh/check.h"
#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

const IndexedMesh& ball() {
    static const IndexedMesh mesh = test::sphere({0, 0, 0}, 10, 4);
    return mesh;
}

double longestOverHeight(const IndexedMesh& mesh, int f) {
    double longest = 0;
    for (int k = 0; k < 3; ++k)
        longest = std::max(longest, (mesh.corner(f, k) - mesh.corner(f, (k + 1) % 3)).squaredNorm());
    return longest / doubleAreaVector(mesh, f).norm();
}

/// A box whose sides are each cut in two again and again.
IndexedMesh fineBox(const Eigen::Vector3d& lo, const Eigen::Vector3d& hi) {
    IndexedMesh mesh = test::box(lo, hi);
    for (int round = 0; round < 4; ++round)
        mesh = test::splitInFour(mesh);
    return mesh;
}

} // namespace

TEST(Decimate, KeepsTheShape) {
    const IndexedMesh coarse = decimate(ball(), 600);
    EXPECT_NEAR(coarse.faceCount(), 600, 10);
    EXPECT_TRUE(diagnose(coarse).usable());
    EXPECT_NEAR(volume(coarse), volume(ball()), 0.03 * volume(ball()));
}

TEST(Decimate, LeavesWhatIsCoarseEnough) {
    const Reduction same = reduce(ball(), ball().faceCount());
    EXPECT_EQ(same.mesh.V, ball().V);
    for (std::size_t v = 0; v < same.pointNow.size(); ++v)
        EXPECT_EQ(same.pointNow[v], static_cast<int>(v));
}

TEST(Decimate, TellsWhereEachPointWent) {
    const Reduction reduction = reduce(ball(), 600);
    ASSERT_EQ(reduction.pointNow.size(), static_cast<std::size_t>(ball().vertexCount()));
    std::vector<int> merged(static_cast<std::size_t>(reduction.mesh.vertexCount()), 0);
    for (int v = 0; v < ball().vertexCount(); ++v) {
        const int now = reduction.pointNow[static_cast<std::size_t>(v)];
        ASSERT_GE(now, 0);
        ASSERT_LT(now, reduction.mesh.vertexCount());
        ++merged[static_cast<std::size_t>(now)];
        EXPECT_LT((ball().point(v) - reduction.mesh.point(now)).norm(), 4) << "of a radius of 10";
    }
    EXPECT_EQ(std::count(merged.begin(), merged.end(), 0), 0) << "every point left was one of the original";
}

TEST(Decimate, KeepsThePointsAskedForAndLaysNoFaceOnThem) {
    std::vector<char> kept;
    for (int v = 0; v < ball().vertexCount(); ++v)
        kept.push_back(std::abs(ball().V(v, 2)) < 1.5);
    const Reduction reduction = reduce(ball(), 700, kept);
    std::vector<char> keptNow(static_cast<std::size_t>(reduction.mesh.vertexCount()), 0);
    for (int v = 0; v < ball().vertexCount(); ++v)
        if (kept[static_cast<std::size_t>(v)]) {
            const int now = reduction.pointNow[static_cast<std::size_t>(v)];
            EXPECT_EQ(reduction.mesh.point(now), ball().point(v));
            keptNow[static_cast<std::size_t>(now)] = 1;
        }
    const auto facesOnKept = [](const IndexedMesh& mesh, const std::vector<char>& points) {
        int count = 0;
        for (int f = 0; f < mesh.faceCount(); ++f)
            count += points[static_cast<std::size_t>(mesh.F(f, 0))] &&
                     points[static_cast<std::size_t>(mesh.F(f, 1))] &&
                     points[static_cast<std::size_t>(mesh.F(f, 2))];
        return count;
    };
    EXPECT_EQ(facesOnKept(reduction.mesh, keptNow), facesOnKept(ball(), kept));
    EXPECT_TRUE(diagnose(reduction.mesh).usable());
}

TEST(Decimate, MakesNoSlimFaces) {
    // The sides of a box have plenty of points in a row.
    const IndexedMesh coarse = decimate(fineBox({0, 0, 0}, {30, 20, 10}), 300);
    for (int f = 0; f < coarse.faceCount(); ++f)
        EXPECT_LE(longestOverHeight(coarse, f), 12.001);
}

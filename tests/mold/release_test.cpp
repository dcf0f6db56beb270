// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/release.h"

#include "base/parallel.h"
#include "mold/bolt_holes.h"
#include "mold/half.h"
#include "mold/mold.h"
#include "support/casts.h"
#include "support/molds.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector3d;

namespace {

Mold moldOf(const KnownCast& cast) {
    return buildMold(test::trayOf(cast), 1, {}).value();
}

/// A block's upper half with a straight hole through it.
IndexedMesh boredHalf() {
    const Block block = uprightBlock({Vector3d(-20, -20, -10), Vector3d(20, 20, 10)});
    HalfSurfaces surfaces;
    surfaces.voids.push_back(
        {std::make_shared<const IndexedMesh>(boltSurface(planCircle({3, 4}, 2, 32), block.end(1)))});
    return assembleHalf(1, surfaces, block).value();
}

/// The same with a fold hardly thicker than rounding where the parting face meets the hole's wall, not at the
/// wall itself but one sliver away.
IndexedMesh withFoldAtRim(IndexedMesh half) {
    constexpr double size = 1e-5; // mm
    const Vector3d axis(3, 4, 0);
    for (int f = 0; f < half.faceCount(); ++f)
        for (int k = 0; k < 3; ++k) {
            const int a = half.F(f, k);
            const int b = half.F(f, (k + 1) % 3);
            const int c = half.F(f, (k + 2) % 3);
            const auto atRim = [&](int v) {
                return half.V(v, 2) == 0 && std::abs((half.point(v) - axis).norm() - 2) < 0.1;
            };
            if (half.V(c, 2) != 0 || !atRim(a) || !atRim(b) || atRim(c))
                continue;
            const Vector3d middle = (half.point(a) + half.point(b)) / 2;
            const Vector3d outwards = (middle - axis).normalized();
            const int first = half.vertexCount();
            half.V.conservativeResize(first + 2, 3);
            half.V.row(first) = (middle + 2 * size * outwards).transpose();
            half.V.row(first + 1) = (middle + size * outwards + Vector3d(0, 0, size)).transpose();
            const auto last = half.F.rows();
            half.F.conservativeResize(last + 4, 3);
            half.F.row(f) << a, b, first;
            half.F.row(last) << a, first, first + 1;
            half.F.row(last + 1) << first, b, first + 1;
            half.F.row(last + 2) << a, first + 1, c;
            half.F.row(last + 3) << first + 1, b, c;
            return half;
        }
    return half;
}

} // namespace

TEST(Release, IsRefusedAlongAnotherDirection) {
    const Mold mold = moldOf(frusta(20, 10, 5, 3, 0.2));
    const Vector3d tilted = Vector3d(0.5, 0, 1).normalized();
    const HalfRelease straight =
        examineRelease(*mold.half1.mesh, *mold.half2.mesh, *mold.cast, Vector3d::UnitZ(), 1);
    const HalfRelease wrong = examineRelease(*mold.half1.mesh, *mold.half2.mesh, *mold.cast, tilted, 1);
    EXPECT_TRUE(straight.sound);
    EXPECT_TRUE(straight.freeToMove());
    EXPECT_FALSE(wrong.stuckFaces.empty());
    EXPECT_FALSE(wrong.sweptFaces.empty());
}

TEST(Release, IsRefusedTowardsTheOtherHalf) {
    const Mold mold = moldOf(frusta(20, 10, 5, 3, 0.2));
    const HalfRelease wrong =
        examineRelease(*mold.half1.mesh, *mold.half2.mesh, *mold.cast, -Vector3d::UnitZ(), 1);
    EXPECT_FALSE(wrong.stuckFaces.empty());
    EXPECT_FALSE(wrong.sweptFaces.empty());
}

TEST(Release, SeesWhatAnglesDoNotShow) {
    // Another body in the way: every face of the half has its draft, and still it cannot leave.
    const Mold mold = moldOf(frusta(20, 10, 5, 3, 0.2));
    const IndexedMesh inTheWay = together(*mold.cast, box({-14, -9, 30}, {14, 9, 32}));
    const HalfRelease blocked =
        examineRelease(*mold.half1.mesh, *mold.half2.mesh, inTheWay, Vector3d::UnitZ(), 1);
    EXPECT_FALSE(blocked.sweptFaces.empty());
}

TEST(Release, TellsRoundingFromWhatIsInTheWay) {
    const Mold mold = moldOf(frusta(20, 10, 5, 3, 0.02)); // steep: what is 1 deep is 50 on its way out
    const auto swept = [&](double aside) {
        IndexedMesh cast = *mold.cast;
        cast.V.col(0).array() += aside;
        return examineRelease(*mold.half1.mesh, *mold.half2.mesh, cast, Vector3d::UnitZ(), 1)
            .sweptFaces.size();
    };
    EXPECT_EQ(swept(5e-5), 0U);
    EXPECT_GT(swept(2e-3), 0U);
    EXPECT_GT(swept(0.1), 0U);
}

TEST(Release, NeedsASoundHalf) {
    const Mold mold = moldOf(frusta(20, 10, 5, 3, 0.2));
    IndexedMesh open = *mold.half1.mesh;
    open.F.conservativeResize(open.F.rows() - 1, 3);
    EXPECT_FALSE(examineRelease(open, *mold.half2.mesh, *mold.cast, Vector3d::UnitZ(), 1).sound);
    const IndexedMesh two = together(*mold.half1.mesh, box({50, 50, 50}, {51, 51, 51}));
    EXPECT_FALSE(examineRelease(two, *mold.half2.mesh, *mold.cast, Vector3d::UnitZ(), 1).sound);
}

TEST(Release, OfAStraightHoleAsksForDraftOnlyWhereSomethingStandsInIt) {
    const Block block = uprightBlock({Vector3d(-20, -20, -10), Vector3d(20, 20, 10)});
    const PlanShape outline = planCircle({3, 4}, 2, 32);
    const IndexedMesh half = boredHalf();
    const IndexedMesh other = box({-20, -20, -10}, {20, 20, 0});
    const auto stuck = [&](const IndexedMesh& cast) {
        return examineRelease(half, other, cast, Vector3d::UnitZ(), 1).stuckFaces.size();
    };
    EXPECT_EQ(stuck(box({-8, -8, -2}, {-6, -6, -1})), 0U);
    EXPECT_EQ(stuck(boltSolid(outline, block)), 64U) << "a plug that fills it holds by friction";
}

TEST(Release, TakesSliversAtABoresRimAsItsWall) {
    const IndexedMesh half = boredHalf();
    const IndexedMesh folded = withFoldAtRim(half);
    ASSERT_EQ(folded.faceCount(), half.faceCount() + 4);
    const IndexedMesh other = box({-20, -20, -10}, {20, 20, 0});
    const IndexedMesh cast = box({-8, -8, -2}, {-6, -6, -1});
    EXPECT_TRUE(examineRelease(folded, other, cast, Vector3d::UnitZ(), 1).stuckFaces.empty());
    // Where the wall is held, so are they.
    const Block block = uprightBlock({Vector3d(-20, -20, -10), Vector3d(20, 20, 10)});
    const IndexedMesh plug = boltSolid(planCircle({3, 4}, 2, 32), block);
    EXPECT_GT(examineRelease(folded, other, plug, Vector3d::UnitZ(), 1).stuckFaces.size(), 64U);
}

TEST(Release, IsTheSameForAnyNumberOfThreads) {
    const Mold mold = moldOf(frusta(20, 10, 5, 3, 0.01));
    std::vector<HalfRelease> found;
    for (const int threads : {1, 2, 3}) {
        setThreadCount(threads);
        found.push_back(examineRelease(*mold.half1.mesh, *mold.half2.mesh, *mold.cast,
                                       Vector3d(0.3, 0, 1).normalized(), 1));
    }
    setThreadCount(0);
    EXPECT_FALSE(found[0].stuckFaces.empty());
    EXPECT_EQ(found[0].stuckFaces, found[1].stuckFaces);
    EXPECT_EQ(found[0].stuckFaces, found[2].stuckFaces);
    EXPECT_EQ(found[0].sweptFaces, found[1].sweptFaces);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/release.h"

#include "mold/mold.h"
#include "support/casts.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector3d;

namespace {

Mold moldOf(const KnownCast& cast) {
    return buildMold(cast.mesh, labelSides(cast.mesh, cast.state.plane), cast.state, 1, {}).value();
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

TEST(Release, NeedsASoundHalf) {
    const Mold mold = moldOf(frusta(20, 10, 5, 3, 0.2));
    IndexedMesh open = *mold.half1.mesh;
    open.F.conservativeResize(open.F.rows() - 1, 3);
    EXPECT_FALSE(examineRelease(open, *mold.half2.mesh, *mold.cast, Vector3d::UnitZ(), 1).sound);
    const IndexedMesh two = together(*mold.half1.mesh, box({50, 50, 50}, {51, 51, 51}));
    EXPECT_FALSE(examineRelease(two, *mold.half2.mesh, *mold.cast, Vector3d::UnitZ(), 1).sound);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/placing.h"

#include "mesh/measures.h"
#include "project/edits.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;
using Eigen::Vector3d;

namespace {

IndexedMesh brick() {
    return test::box(Vector3d(0, 0, 0), Vector3d(1, 2, 3));
}

} // namespace

TEST(Placing, LayFlatPutsTheFaceOnTheGround) {
    const Placement flat = moved({}, layFlat(brick(), Vector3d::UnitX()));
    const Eigen::AlignedBox3d box = boundingBox(placed(brick(), flat));
    EXPECT_NEAR(box.min().z(), 0, 1e-12);
    EXPECT_NEAR(box.sizes().z(), 1, 1e-12);
}

TEST(Placing, FourQuarterTurnsAreNoneToTheBit) {
    Placement placement;
    for (int turn = 0; turn < 4; ++turn)
        placement = moved(placement, quarterTurn(placed(brick(), placement), Vector3d::UnitY()));
    EXPECT_EQ(placed(brick(), placement).V, brick().V);
}

TEST(Placing, ATurnByAnyAngleKeepsTheMiddleAndFourOfTwentyTwoAndAHalfAreAQuarter) {
    const IndexedMesh part = brick();
    const Vector3d middle = boundingBox(part).center();
    const Eigen::Isometry3d turn = turnAbout(part, Vector3d::UnitZ(), 22.5);
    EXPECT_LT((turn * middle - middle).norm(), 1e-12);
    const Eigen::Isometry3d four = turn * turn * turn * turn;
    EXPECT_LT((four.matrix() - quarterTurn(part, Vector3d::UnitZ()).matrix()).norm(), 1e-12);
}

TEST(Placing, AnInchIsExact) {
    EXPECT_EQ(millimetres(Unit::Inch), 25.4);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/working_frame.h"

#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

class Frame : public testing::Test {
protected:
    IndexedMesh m_part = test::box({10, 20, 30}, {40, 60, 100});
    MoldState m_state{{Eigen::Vector3d(1, -2, 3).normalized(), 40}, {}};
    WorkingFrame m_frame{m_part, m_state};
};

} // namespace

TEST_F(Frame, GoesThereAndBack) {
    const IndexedMesh back = m_frame.toPart(m_frame.toWork(m_part));
    EXPECT_LT((back.V - m_part.V).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_EQ(back.F, m_part.F);
    const Eigen::Vector3d x(3, -7, 11);
    EXPECT_LT((m_frame.toPart(m_frame.toWork(x)) - x).norm(), 1e-12);
}

TEST_F(Frame, PutsThePlaneAtZeroAndSideOneUp) {
    for (int v = 0; v < m_part.vertexCount(); ++v) {
        const Eigen::Vector3d x = m_part.point(v);
        EXPECT_NEAR(m_frame.toWork(x).z() * m_frame.scale(), m_state.plane.distance(x), 1e-12);
    }
}

TEST_F(Frame, MakesThePartAsLargeAsOneWithoutMirroringIt) {
    EXPECT_DOUBLE_EQ(m_frame.scale(), diagonal(m_part));
    const IndexedMesh work = m_frame.toWork(m_part);
    EXPECT_NEAR((work.point(0) - work.point(7)).norm(), 1, 1e-12);
    EXPECT_NEAR(volume(work) * std::pow(m_frame.scale(), 3), volume(m_part), 1e-9);
}

TEST_F(Frame, TurnsDirectionsButNeitherMovesNorScalesThem) {
    const Directions work = m_frame.directionsToWork(Directions::normalTo(m_state.plane));
    EXPECT_LT((work.d1 - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
    EXPECT_LT((work.d2 + Eigen::Vector3d::UnitZ()).norm(), 1e-12);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/tet_topology.h"

#include "support/solids.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace moldwright;

namespace {

class TetTopology : public testing::Test {
protected:
    [[nodiscard]] bool has(int tet, int point) const {
        return (m_solid.tets.T.row(tet).array() == point).any();
    }

    test::Solid m_solid = test::solidBox({0, 0, 0}, {3, 2, 1}, {3, 2, 2});
};

} // namespace

TEST_F(TetTopology, NeighboursShareTheFaceOppositeTheCorner) {
    const Tetrahedra& T = m_solid.tets.T;
    const auto neighbours = tetNeighbours(T);
    int outside = 0;
    for (int t = 0; t < T.rows(); ++t)
        for (int k = 0; k < 4; ++k) {
            const auto& own = neighbours[static_cast<std::size_t>(t)];
            const int other = own[static_cast<std::size_t>(k)];
            if (other < 0) {
                ++outside;
                continue;
            }
            EXPECT_FALSE(has(other, T(t, k)));
            for (int i = 1; i < 4; ++i)
                EXPECT_TRUE(has(other, T(t, (k + i) % 4)));
            EXPECT_EQ(std::ranges::count(neighbours[static_cast<std::size_t>(other)], t), 1);
        }
    EXPECT_EQ(outside, m_solid.F.rows());
}

TEST_F(TetTopology, EachSurfaceFaceHasItsTetBehindIt) {
    const std::vector<int> behind = tetsBehindFaces(m_solid.tets.T, m_solid.F);
    for (int f = 0; f < m_solid.F.rows(); ++f) {
        ASSERT_GE(behind[static_cast<std::size_t>(f)], 0);
        for (int k = 0; k < 3; ++k)
            EXPECT_TRUE(has(behind[static_cast<std::size_t>(f)], m_solid.F(f, k)));
    }
    Triangles foreign(1, 3);
    foreign << 0, 1, static_cast<int>(m_solid.tets.V.rows());
    EXPECT_EQ(tetsBehindFaces(m_solid.tets.T, foreign), std::vector{-1});
}

TEST_F(TetTopology, CountsTetsTurnedInsideOut) {
    Points V = m_solid.tets.V;
    EXPECT_EQ(invertedCount(m_solid.tets.T, V), 0);
    V.col(0) *= -1;
    EXPECT_EQ(invertedCount(m_solid.tets.T, V), m_solid.tets.T.rows());
    Tetrahedra oneTurned = m_solid.tets.T;
    std::swap(oneTurned(5, 0), oneTurned(5, 1));
    EXPECT_EQ(invertedCount(oneTurned, m_solid.tets.V), 1);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/plane_system.h"

#include "base/parallel.h"
#include "support/solids.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

class System : public testing::Test {
protected:
    /// (A + shift) X − B where A is the body's Laplacian.
    [[nodiscard]] Positions residual(const PlaneSystem& system, const Positions& X) const {
        return m_A.selfadjointView<Eigen::Lower>() * X + system.shift() * X - m_B;
    }

    test::Solid m_solid = test::solidBox({-1, -1, -1}, {1, 1, 1}, {3, 2, 2});
    Eigen::SparseMatrix<double> m_A =
        ElasticBody({m_solid.tets.V, m_solid.tets.T, m_solid.F, {}, 0.5, 0}).laplacian();
    Positions m_B = Positions::Random(m_A.rows(), 3);
    std::vector<char> m_none = std::vector<char>(static_cast<std::size_t>(m_A.rows()), 0);
};

} // namespace

TEST_F(System, SolvesAllCoordinatesAlikeWithoutHeldPoints) {
    PlaneSystem system(m_A, m_none);
    ASSERT_TRUE(system.factor(m_A));
    EXPECT_GT(system.shift(), 0);
    // A constant added to B leaves the singular direction to the shift: the residual is relative to X.
    const Positions X = system.solve(m_B);
    EXPECT_LT(residual(system, X).norm(), 1e-9 * X.norm());
}

TEST_F(System, HoldsPointsInThePlaneAndLetsThemSlideInIt) {
    std::vector<char> held = m_none;
    held[0] = held[7] = held[11] = 1;
    PlaneSystem system(m_A, held);
    ASSERT_TRUE(system.factor(m_A));
    const Positions X = system.solve(m_B);
    const Positions r = residual(system, X);
    for (Eigen::Index v = 0; v < X.rows(); ++v) {
        if (held[static_cast<std::size_t>(v)]) {
            EXPECT_EQ(X(v, 2), 0);
            EXPECT_NE(X(v, 0), 0);
        } else {
            EXPECT_NEAR(r(v, 2), 0, 1e-10);
        }
    }
    EXPECT_LT(r.leftCols<2>().norm(), 1e-9 * X.norm());
}

TEST_F(System, FixedPointsDoNotMoveAndTheOthersSolveWithoutThem) {
    std::vector<char> fixed(m_none.size(), 0);
    fixed[0] = fixed[3] = 1;
    PlaneSystem system(m_A, m_none, fixed);
    ASSERT_TRUE(system.factor(m_A));
    const Positions B = Positions::Random(m_A.rows(), 3);
    const Positions X = system.solve(B);
    const Positions r = m_A.selfadjointView<Eigen::Lower>() * X + system.shift() * X - B;
    for (Eigen::Index v = 0; v < X.rows(); ++v) {
        if (fixed[static_cast<std::size_t>(v)])
            EXPECT_EQ(X.row(v), Eigen::RowVector3d::Zero());
        else
            EXPECT_LT(r.row(v).norm(), 1e-10);
    }
}

TEST_F(System, TheShiftKeepsThePresentPlace) {
    PlaneSystem system(m_A, m_none);
    ASSERT_TRUE(system.factor(m_A));
    const Positions X0 = Positions(m_solid.tets.V).rowwise() + Eigen::RowVector3d(3, -2, 5);
    const Positions rest = m_A.selfadjointView<Eigen::Lower>() * X0 + system.shift() * X0;
    EXPECT_LT((system.solve(rest) - X0).norm(), 1e-6);
}

TEST_F(System, RefusesANegativeMatrix) {
    PlaneSystem system(m_A, m_none);
    EXPECT_FALSE(system.factor(-m_A));
}

TEST_F(System, GivesTheSameBitsForAnyNumberOfThreads) {
    const test::Solid solid = test::solidBox({-1, -1, -1}, {1, 1, 1}, {9, 8, 7});
    const Eigen::SparseMatrix<double> A =
        ElasticBody({solid.tets.V, solid.tets.T, solid.F, {}, 0, 0}).laplacian();
    const Positions B = Positions::Random(A.rows(), 3);
    std::vector<Positions> solutions;
    for (const int threads : {1, 2, 2, 4}) {
        setThreadCount(threads);
        PlaneSystem system(A, std::vector<char>(static_cast<std::size_t>(A.rows()), 0));
        ASSERT_TRUE(system.factor(A));
        solutions.push_back(system.solve(B));
    }
    setThreadCount(0);
    for (const Positions& X : solutions)
        EXPECT_EQ(X, solutions.front());
}

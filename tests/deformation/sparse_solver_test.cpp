// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/sparse_solver.h"

#include "base/parallel.h"
#include "base/vector_code.h"

#include <gtest/gtest.h>

#include <random>

using namespace moldwright;

namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// A random symmetric matrix with about six entries a row and a dominant diagonal.
Matrix anyPositiveDefinite(int n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> index(0, n - 1);
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < 3 * n; ++i) {
        const int a = index(random);
        const int b = index(random);
        const double x = number(random);
        if (a == b)
            continue;
        entries.emplace_back(std::max(a, b), std::min(a, b), x);
        entries.emplace_back(a, a, std::abs(x));
        entries.emplace_back(b, b, std::abs(x));
    }
    for (int i = 0; i < n; ++i)
        entries.emplace_back(i, i, 0.1);
    Matrix A(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
}

/// Cubes of n×n×n points each, a point bound to its six neighbours: large enough to be solved in subtrees.
Matrix cubes(int n, int count) {
    std::vector<Eigen::Triplet<double>> entries;
    const auto at = [&](int cube, int x, int y, int z) { return ((cube * n + x) * n + y) * n + z; };
    for (int cube = 0; cube < count; ++cube)
        for (int x = 0; x < n; ++x)
            for (int y = 0; y < n; ++y)
                for (int z = 0; z < n; ++z) {
                    const int own = at(cube, x, y, z);
                    entries.emplace_back(own, own, 6.1);
                    if (x > 0)
                        entries.emplace_back(own, at(cube, x - 1, y, z), -1);
                    if (y > 0)
                        entries.emplace_back(own, at(cube, x, y - 1, z), -1);
                    if (z > 0)
                        entries.emplace_back(own, at(cube, x, y, z - 1), -1);
                }
    const int size = count * n * n * n;
    Matrix A(size, size);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
}

double residual(const Matrix& A, const Eigen::MatrixXd& X, const Eigen::MatrixXd& B) {
    return (A.selfadjointView<Eigen::Lower>() * X - B).norm() / B.norm();
}

class Solver : public testing::Test {
protected:
    void SetUp() override { m_solver.analyze(m_A); }

    Matrix m_A = anyPositiveDefinite(400, 1);
    Eigen::MatrixXd m_B = Eigen::MatrixXd::Random(400, 3);
    SparseSolver m_solver;
};

} // namespace

TEST_F(Solver, SolvesARandomSystem) {
    ASSERT_TRUE(m_solver.factor(m_A));
    EXPECT_LT(residual(m_A, m_solver.solve(m_B), m_B), 1e-12);
    EXPECT_GE(m_solver.factorBytes(), 8.0 * 400);
}

TEST_F(Solver, AnyNumberOfRightHandSidesAlikeForAnyVectorWidth) {
    ASSERT_TRUE(m_solver.factor(m_A));
    const Eigen::MatrixXd B = Eigen::MatrixXd::Random(400, 5);
    const Eigen::MatrixXd X = m_solver.solve(B);
    for (const int columns : {1, 2, 3})
        EXPECT_TRUE(m_solver.solve(B.leftCols(columns)).isApprox(X.leftCols(columns), 1e-13));
    for (const VectorCode code : {VectorCode::Plain, VectorCode::Avx2, VectorCode::Avx512}) {
        limitVectorCode(code);
        EXPECT_EQ(m_solver.solve(B), X);
    }
}

TEST(LargeSystem, SolvedInSubtreesAlikeForAnyNumberOfThreads) {
    for (const int count : {1, 3}) {
        const Matrix A = cubes(18, count);
        const Eigen::MatrixXd B = Eigen::MatrixXd::Random(A.rows(), 3);
        SparseSolver solver;
        solver.analyze(A);
        ASSERT_TRUE(solver.factor(A));
        ASSERT_FALSE(solver.fellBack());
        const Eigen::MatrixXd X = solver.solve(B);
        EXPECT_LT(residual(A, X, B), 1e-14) << count;
        for (const int threads : {1, 2, 4}) {
            setThreadCount(threads);
            EXPECT_EQ(solver.solve(B), X) << threads;
        }
        setThreadCount(0);
    }
}

TEST_F(Solver, TakesOverTheAnalysisOfAnother) {
    ASSERT_TRUE(m_solver.factor(m_A));
    SparseSolver other;
    other.analyzeLike(m_solver);
    const Matrix twice = 2 * m_A;
    ASSERT_TRUE(other.factor(twice));
    EXPECT_FALSE(other.fellBack());
    EXPECT_LT(residual(twice, other.solve(m_B), m_B), 1e-12);
    EXPECT_LT(residual(m_A, m_solver.solve(m_B), m_B), 1e-12);
}

TEST_F(Solver, FactorsNewNumbersInTheSamePattern) {
    ASSERT_TRUE(m_solver.factor(m_A));
    Matrix other = m_A;
    for (int c = 0; c < other.outerSize(); ++c)
        for (Matrix::InnerIterator it(other, c); it; ++it)
            it.valueRef() *= it.row() == it.col() ? 3 : -0.5;
    ASSERT_TRUE(m_solver.factor(other));
    const Eigen::MatrixXd X = m_solver.solve(m_B);
    EXPECT_LT(residual(other, X, m_B), 1e-12);
    EXPECT_GT(residual(m_A, X, m_B), 0.1);
}

TEST_F(Solver, RefusesAMatrixThatIsNotPositiveDefinite) {
    Matrix indefinite = m_A;
    indefinite.coeffRef(200, 200) = -5;
    EXPECT_FALSE(m_solver.factor(indefinite));
    ASSERT_TRUE(m_solver.factor(m_A)) << "one refusal must not spoil the solver";
    EXPECT_LT(residual(m_A, m_solver.solve(m_B), m_B), 1e-12);
}

TEST_F(Solver, GivesTheSameBitsEachTime) {
    ASSERT_TRUE(m_solver.factor(m_A));
    const Eigen::MatrixXd X = m_solver.solve(m_B);
    SparseSolver again;
    again.analyze(m_A);
    ASSERT_TRUE(again.factor(m_A));
    EXPECT_EQ(again.solve(m_B), X);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/side_heights.h"

#include "support/finite_differences.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moldwright;

namespace {

class Heights : public testing::Test {
protected:
    Heights() { m_rest << 1, 2, 0.5, 3, 4, -0.25, 5, 6, 0, 7, 8, 1e-4, 9, 10, -0.5; }

    Positions m_rest{5, 3};
    std::vector<signed char> m_side = {1, -1, 0, 1, 0}; ///< the last one is free though it lies below
    SideHeights m_heights{m_side, m_rest};
};

} // namespace

TEST_F(Heights, GoThereAndBack) {
    Positions X = m_rest;
    X.col(2) *= 0.37;
    EXPECT_LT((m_heights.toPositions(m_heights.toFree(X)) - X).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_LT((m_heights.toFree(m_heights.toPositions(X)) - X).cwiseAbs().maxCoeff(), 1e-15);
}

TEST_F(Heights, KeepTheirSignForAnyFreeNumber) {
    for (const double u : {-1e3, -1.0, -1e-6, 0.0, 1e-6, 1.0}) {
        Positions U = m_rest;
        U.col(2).setConstant(u);
        const Positions X = m_heights.toPositions(U);
        EXPECT_GT(X(0, 2), 0) << u;
        EXPECT_LT(X(1, 2), 0) << u;
        EXPECT_GT(X(3, 2), 0) << u;
        EXPECT_EQ(X(2, 2), u);
        EXPECT_EQ(X(4, 2), u);
        EXPECT_EQ(X.leftCols<2>(), U.leftCols<2>());
    }
}

TEST_F(Heights, AreNearlyThemselvesFarFromThePlane) {
    EXPECT_NEAR(m_heights.toFree(m_rest)(0, 2), 0.5, 1e-6);
}

TEST_F(Heights, PullBackAgreesWithFiniteDifferences) {
    Positions U = m_heights.toFree(m_rest);
    U(0, 2) = 1e-4; // where the curve bends
    U(1, 2) = 3e-4; // beyond the plane
    U(3, 2) = -2e-5;
    const auto f = [&](const Eigen::VectorXd& u) {
        const Positions X = m_heights.toPositions(Eigen::Map<const Positions>(u.data(), 5, 3));
        return X.squaredNorm() + 100 * X.col(2).sum();
    };
    const Positions X = m_heights.toPositions(U);
    Positions gradient = 2 * X;
    gradient.col(2).array() += 100;
    m_heights.pullBack(U, gradient);
    const Eigen::VectorXd numeric =
        test::finiteDifferences(f, Eigen::Map<const Eigen::VectorXd>(U.data(), U.size()), 1e-8);
    const Eigen::VectorXd analytic = Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size());
    EXPECT_LT(test::relativeError(analytic, numeric), 1e-6);
    EXPECT_LT(gradient(1, 2) / 100, 0.5); // far on the wrong side it hardly moves
}

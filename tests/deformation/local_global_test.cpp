// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/local_global.h"

#include "deformation/rotation_fit.h"
#include "deformation/side_hinge.h"
#include "support/solids.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>

using namespace moldwright;

namespace {

class Bar : public testing::Test {
protected:
    Bar() : m_none(static_cast<std::size_t>(m_solid.tets.V.rows()), 0) {
        m_idle.assign(static_cast<std::size_t>(m_solid.F.rows()), 0);
    }
    [[nodiscard]] BodyShape shape() const { return {m_solid.tets.V, m_solid.tets.T, m_solid.F, {}, 0, 0}; }

    /// The linear map that takes the centred rest shape nearest to X.
    [[nodiscard]] Eigen::Matrix3d linearMap(const Positions& X) const {
        const Eigen::MatrixXd V = m_solid.tets.V.rowwise() - m_solid.tets.V.colwise().mean();
        const Eigen::MatrixXd Y = X.rowwise() - X.colwise().mean();
        return (V.transpose() * V).ldlt().solve(V.transpose() * Y).transpose();
    }

    test::Solid m_solid = test::solidBox({-0.1, -0.1, 0.1}, {0.1, 0.1, 0.9}, {2, 2, 6});
    std::vector<char> m_none;
    SideLabels m_idle;
};

} // namespace

TEST_F(Bar, AtRestStaysAtRestWhereverItIs) {
    LocalGlobal solver(shape(), m_none, 0.1);
    const Eigen::Isometry3d motion =
        Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(2, Eigen::Vector3d(1, 1, 2).normalized());
    const Positions moved =
        (m_solid.tets.V * motion.linear().transpose()).rowwise() + motion.translation().transpose();
    solver.setPositions(moved);
    for (int i = 0; i < 5; ++i)
        EXPECT_LT(solver.iterate(m_idle, {}, 0.1), 1e-16);
    EXPECT_LT((solver.positions() - moved).cwiseAbs().maxCoeff(), 1e-7);
}

TEST_F(Bar, ComesBackToItsShapeFromADisturbance) {
    LocalGlobal solver(shape(), m_none, 0);
    solver.setPositions(Positions(m_solid.tets.V) + 0.01 * Positions::Random(m_solid.tets.V.rows(), 3));
    double motion = 1;
    for (int i = 0; i < 100; ++i)
        motion = solver.iterate(m_idle, {}, 0.1);
    EXPECT_LT(motion, 1e-9);
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(linearMap(solver.positions()));
    EXPECT_LT((svd.singularValues() - Eigen::Vector3d::Ones()).norm(), 1e-3);
}

TEST_F(Bar, AnUndercutWallTurnsTheBarRatherThanShearingIt) {
    // Only the wall that looks along +x is asked for anything; removal along d leaves it 10° short of 5°.
    SideLabels sides = m_idle;
    for (Eigen::Index f = 0; f < m_solid.F.rows(); ++f) {
        const bool wall = m_solid.tets.V(m_solid.F(f, 0), 0) == 0.1 &&
                          m_solid.tets.V(m_solid.F(f, 1), 0) == 0.1 &&
                          m_solid.tets.V(m_solid.F(f, 2), 0) == 0.1;
        sides[static_cast<std::size_t>(f)] = wall;
    }
    const Directions directions{{-std::sin(radians(5)), 0, std::cos(radians(5))}, -Eigen::Vector3d::UnitZ()};
    LocalGlobal solver(shape(), m_none, 0.1);
    for (int i = 0; i < 400; ++i)
        solver.iterate(sides, directions, std::sin(radians(5)));
    const Eigen::Matrix3d A = linearMap(solver.positions());
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(A);
    EXPECT_LT((svd.singularValues() - Eigen::Vector3d::Ones()).norm(), 0.01);
    const Eigen::AngleAxisd turn(fitRotation(A));
    EXPECT_NEAR(degrees(turn.angle()), 10, 0.5);
    EXPECT_GT(-turn.axis().y(), 0.999); // the wall's normal tips up
}

TEST_F(Bar, HeldPointsLandInThePlaneAndTheCentroidOfAFreeBodyStays) {
    LocalGlobal free(shape(), m_none, 0.1);
    free.iterate(m_idle, {}, 0.1);
    EXPECT_LT((free.positions().colwise().mean() - m_solid.tets.V.colwise().mean()).norm(), 1e-9);
    std::vector<char> held = m_none;
    held[2] = held[20] = 1;
    LocalGlobal solver(shape(), m_none, 0.1);
    solver.setHeld(held);
    for (int i = 0; i < 20; ++i)
        solver.iterate(m_idle, {}, 0.1);
    EXPECT_EQ(solver.positions()(2, 2), 0);
    EXPECT_EQ(solver.positions()(20, 2), 0);
    EXPECT_EQ(solver.system().held(), held);
}

TEST_F(Bar, APlasticRestartTakesTheShapeAsItIs) {
    LocalGlobal solver(shape(), m_none, 0);
    Positions bent = m_solid.tets.V;
    bent.col(0).array() += bent.col(2).array().square(); // far from its rest shape
    solver.setPositions(bent);
    solver.restart();
    EXPECT_EQ(solver.positions(), bent);
    EXPECT_EQ(solver.shape().V, Points(bent));
    EXPECT_LT(solver.iterate(m_idle, {}, 0.1), 1e-16);
    LocalGlobal elastic(shape(), m_none, 0);
    elastic.setPositions(bent);
    EXPECT_GT(elastic.iterate(m_idle, {}, 0.1), 1e-6) << "without a restart it springs back";
}

TEST_F(Bar, WhatIsImportantKeepsItsShapeWhileTheRestGivesWay) {
    // The two ends pull against each other: pins at the top and at the bottom of one wall cannot both be met
    // without bending; the heavy half bends less.
    std::vector<double> weights;
    for (Eigen::Index t = 0; t < m_solid.tets.T.rows(); ++t) {
        double z = 0;
        for (int k = 0; k < 4; ++k)
            z += m_solid.tets.V(m_solid.tets.T(t, k), 2) / 4;
        weights.push_back(z > 0.5 ? 100 : 1);
    }
    std::vector<char> held = m_none;
    for (Eigen::Index v = 0; v < m_solid.tets.V.rows(); ++v)
        held[static_cast<std::size_t>(v)] =
            m_solid.tets.V(v, 0) == 0.1 && (m_solid.tets.V(v, 2) == 0.9 || m_solid.tets.V(v, 2) == 0.1);
    LocalGlobal solver(shape(), held, 0);
    solver.setTetWeights(weights);
    for (int i = 0; i < 60; ++i)
        solver.iterate(m_idle, {}, 0.1);
    const auto energyOf = [&](bool upper) {
        BodyShape half = shape();
        for (Eigen::Index t = 0; t < half.T.rows(); ++t)
            half.tetWeights.push_back((weights[static_cast<std::size_t>(t)] > 1) == upper ? 1 : 0);
        Positions gradient = Positions::Zero(half.V.rows(), 3);
        return ElasticBody(half).energy(solver.positions(), 1, gradient);
    };
    EXPECT_LT(energyOf(true), 0.5 * energyOf(false));
}

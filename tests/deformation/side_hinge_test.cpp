// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/side_hinge.h"

#include "deformation/labelled_shapes.h"
#include "support/finite_differences.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <random>

using namespace moldwright;

namespace {

class Hinge : public testing::Test {
protected:
    /// A sphere moved off the plane's frame: some faces of each side miss 20°.
    [[nodiscard]] SideHinge hinge() const {
        return {m_ball.F, m_labels, m_directions, std::sin(radians(20)), m_weights};
    }
    [[nodiscard]] double energyAt(const Eigen::VectorXd& x) const {
        const Positions X = Eigen::Map<const Positions>(x.data(), x.size() / 3, 3);
        Positions gradient = Positions::Zero(X.rows(), 3);
        return hinge().energy(X, 1, gradient);
    }

    IndexedMesh m_ball = test::sphere({0, 0, 0}, 1, 2);
    SideLabels m_labels = test::labelsByHeight(m_ball);
    Directions m_directions{Eigen::Vector3d(0.1, 0.2, 1).normalized(),
                            Eigen::Vector3d(-0.2, 0.1, -1).normalized()};
    std::vector<double> m_weights = std::vector<double>(static_cast<std::size_t>(m_ball.faceCount()), 0.3);
};

} // namespace

TEST_F(Hinge, GradientAgreesWithFiniteDifferences) {
    const Positions X = Positions(m_ball.V) + 0.02 * Positions::Random(m_ball.V.rows(), 3);
    Positions gradient = Positions::Zero(X.rows(), 3);
    EXPECT_GT(hinge().energy(X, 1, gradient), 0.01);
    const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(X.data(), X.size());
    const Eigen::VectorXd numeric =
        test::finiteDifferences([&](const Eigen::VectorXd& y) { return energyAt(y); }, x);
    const Eigen::VectorXd analytic = Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size());
    EXPECT_LT(test::relativeError(analytic, numeric), 1e-6);
}

TEST_F(Hinge, AFaceByHand) {
    Triangles F(1, 3);
    F << 0, 1, 2;
    const SideLabels labels = {2};
    const SideHinge one{F, labels, {}, 0.5, {3}};
    Positions X(3, 3);
    X << 0, 0, 0, 1, 0, 0, 0, 1, 0; // looks up, belongs to the side that opens downwards
    Positions gradient = Positions::Zero(3, 3);
    EXPECT_DOUBLE_EQ(one.energy(X, 1, gradient), 0.5 * 3 * 1.5 * 1.5);
    X.row(1).swap(X.row(2));
    EXPECT_EQ(one.energy(X, 1, gradient), 0);
}

TEST_F(Hinge, SideDraftCountsWhatMisses) {
    const SideDraft draft = sideDraft(m_ball.F, m_labels, m_directions, m_ball.V, std::sin(radians(20)));
    double worst = 1;
    int violating = 0;
    for (int f = 0; f < m_ball.faceCount(); ++f) {
        const Eigen::Vector3d N = (m_ball.corner(f, 1) - m_ball.corner(f, 0))
                                      .cross(m_ball.corner(f, 2) - m_ball.corner(f, 0))
                                      .normalized();
        const double sine = N.dot(m_directions.of(m_labels[static_cast<std::size_t>(f)]));
        worst = std::min(worst, sine);
        violating += sine < std::sin(radians(20));
    }
    EXPECT_DOUBLE_EQ(draft.worstSine, worst);
    EXPECT_EQ(draft.violating, violating);
    EXPECT_GT(violating, 0);
    EXPECT_GT(draft.violatingArea, 0);
}

TEST(CastableRotation, ReachesTheDraftByTheSmallestAngle) {
    std::mt19937 random(3);
    std::normal_distribution<double> number;
    const double tau = std::sin(radians(2));
    int turned = 0;
    for (int i = 0; i < 500; ++i) {
        const auto any = [&] {
            return Eigen::Vector3d(number(random), number(random), number(random)).normalized();
        };
        const Eigen::Vector3d N = any();
        const Eigen::Vector3d d = any();
        const Eigen::Quaterniond Q = castableRotation(N, d, tau);
        EXPECT_NEAR(Q.norm(), 1, 1e-12);
        if (N.dot(d) >= tau) {
            EXPECT_EQ(Q.coeffs(), Eigen::Quaterniond::Identity().coeffs());
            continue;
        }
        ++turned;
        EXPECT_NEAR((Q * N).dot(d), tau, 1e-12);
        // No rotation can change the angle between N and d by more than its own.
        const double angle = Eigen::AngleAxisd(Q).angle();
        EXPECT_NEAR(angle, std::acos(N.dot(d)) - std::acos(tau), 1e-9);
    }
    EXPECT_GT(turned, 200);
}

TEST(CastableRotation, TurnsANormalThatLooksStraightBack) {
    const Eigen::Vector3d d = Eigen::Vector3d(1, 2, 3).normalized();
    const Eigen::Quaterniond Q = castableRotation(-d, d, 0.1);
    EXPECT_NEAR((Q * Eigen::Vector3d(-d)).dot(d), 0.1, 1e-12);
    EXPECT_NEAR(Q.norm(), 1, 1e-12);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/labelled_problem.h"

#include "deformation/labelled_shapes.h"
#include "deformation/side_hinge.h"
#include "mesh/measures.h"
#include "support/finite_differences.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

class Problem : public testing::Test {
protected:
    Problem() {
        const IndexedMesh surface{m_body.shape.V, m_body.shape.F};
        for (int f = 0; f < surface.faceCount(); ++f)
            m_areas.push_back(doubleAreaVector(surface, f).norm() / 2);
        m_weights = {1, 3, 0.5, std::sin(radians(2)), 60, 1e-6};
    }
    [[nodiscard]] double valueAt(const Positions& X) const {
        Positions gradient;
        return m_problem.value(m_weights, m_areas, X, gradient);
    }
    [[nodiscard]] LabelledSurface surfaceAt(const Positions& X) const {
        return {{Points(X), m_body.shape.F}, m_body.labels, {}};
    }
    /// The body pushed out of shape, held points in the plane, the parting line pinched so that its barrier
    /// acts.
    [[nodiscard]] Positions disturbed() const {
        Positions X = m_body.shape.V + 0.02 * Positions::Random(m_body.shape.V.rows(), 3);
        for (Eigen::Index v = 0; v < X.rows(); ++v)
            if (m_body.held[static_cast<std::size_t>(v)])
                X.row(v) << 0.3 * X(v, 0), X(v, 1), 0;
        return X;
    }

    LabelledBody m_body = test::labelledBox();
    LabelledProblem m_problem{m_body};
    std::vector<double> m_areas;
    StageWeights m_weights;
};

} // namespace

TEST_F(Problem, GradientAgreesWithFiniteDifferences) {
    const Positions X = disturbed();
    Positions gradient;
    EXPECT_GT(m_problem.value(m_weights, m_areas, X, gradient), 0);
    Positions barrierPart = Positions::Zero(X.rows(), 3);
    EXPECT_GT(m_problem.barrier().energy(X, 1, barrierPart), 0) << "the barrier has to take part";
    const Eigen::VectorXd numeric = test::finiteDifferences(
        [&](const Eigen::VectorXd& x) {
            return valueAt(Eigen::Map<const Positions>(x.data(), x.size() / 3, 3));
        },
        Eigen::Map<const Eigen::VectorXd>(X.data(), X.size()));
    Positions expected = Eigen::Map<const Positions>(numeric.data(), X.rows(), 3);
    for (Eigen::Index v = 0; v < X.rows(); ++v)
        if (m_body.held[static_cast<std::size_t>(v)]) {
            EXPECT_EQ(gradient(v, 2), 0);
            expected(v, 2) = 0; // held: its height is no unknown
        }
    EXPECT_LT((gradient - expected).norm(), 1e-6 * expected.norm());
}

TEST_F(Problem, MinimisingDecreasesAndBringsUprightWallsTowardsTheirDraft) {
    const Positions start = m_body.shape.V;
    const double before = valueAt(start);
    double last = before;
    const Positions X = m_problem.minimize(m_weights, m_areas, start, [&](const Positions& Y) {
        const double value = valueAt(Y);
        EXPECT_LE(value, last * (1 + 1e-12));
        last = value;
        return true;
    });
    EXPECT_LT(valueAt(X), 0.7 * before);
    EXPECT_GT(m_problem.iterations(), 3);
    const auto worst = [&](const Positions& Y) {
        return sideDraft(m_body.shape.F, m_body.labels, m_body.directions, Y, m_weights.tau).worstSine;
    };
    EXPECT_LT(worst(start), 1e-12);
    EXPECT_GT(worst(X), 0.2 * m_weights.tau);
}

TEST_F(Problem, KeepsThePartingLineSimpleAndEverySideOnItsSide) {
    m_weights.hinge = 1000;
    m_weights.tau = std::sin(radians(40)); // much more than the shape can bear without folding up
    const Positions X = m_problem.minimize(m_weights, m_areas, m_body.shape.V, [&](const Positions& Y) {
        EXPECT_TRUE(test::soundlyParted(surfaceAt(Y)));
        return true;
    });
    EXPECT_GT((X - Positions(m_body.shape.V)).norm(), 0.05);
    EXPECT_TRUE(test::soundlyParted(surfaceAt(X)));
    for (Eigen::Index v = 0; v < X.rows(); ++v)
        if (m_body.held[static_cast<std::size_t>(v)]) {
            EXPECT_EQ(X(v, 2), 0);
        }
}

TEST_F(Problem, EndsWhenTheWatchSaysSo) {
    int seen = 0;
    (void)m_problem.minimize(m_weights, m_areas, m_body.shape.V,
                             [&](const Positions&) { return ++seen < 3; });
    EXPECT_EQ(seen, 3);
}

TEST_F(Problem, StaysAtRestWhereNothingIsWanted) {
    m_weights.hinge = 0;
    const Positions X =
        m_problem.minimize(m_weights, m_areas, m_body.shape.V, [](const Positions&) { return true; });
    EXPECT_LT((X - Positions(m_body.shape.V)).cwiseAbs().maxCoeff(), 1e-9);
}

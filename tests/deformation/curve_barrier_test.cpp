// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/curve_barrier.h"

#include "support/finite_differences.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace moldwright;

namespace {

/// Two facing rows of segments, a slot `gap` wide: the curve of two limbs side by side.
class Slot : public testing::Test {
protected:
    static constexpr int kRow = 5;

    static Positions slot(double gap) {
        Positions X(2 * kRow, 3);
        for (int i = 0; i < kRow; ++i) {
            X.row(i) << i, 0, 0;
            X.row(kRow + i) << kRow - 1 - i + 0.3, gap, 0;
        }
        return X;
    }
    static std::vector<std::array<int, 2>> segments() {
        std::vector<std::array<int, 2>> edges;
        for (int i = 0; i + 1 < kRow; ++i) {
            edges.push_back({i, i + 1});
            edges.push_back({kRow + i, kRow + i + 1});
        }
        return edges;
    }
    [[nodiscard]] double energyAt(const Positions& X) const {
        Positions gradient = Positions::Zero(X.rows(), 3);
        return m_barrier.energy(X, 1, gradient);
    }
    static double leastDistance(const Positions& X) {
        double least = std::numeric_limits<double>::infinity();
        const auto at = [&](int v) { return Eigen::Vector2d(X.row(v).head<2>()); };
        for (const auto& [a, b] : segments())
            for (int p = 0; p < 2 * kRow; ++p)
                if (p != a && p != b)
                    least = std::min(least, segmentDistance(at(p), at(a), at(b)).distance);
        return least;
    }
    /// The upper row towards the lower one by `way`, everything shaken a little.
    static Positions closing(double way) {
        Positions D = 0.01 * Positions::Random(2 * kRow, 3);
        D.col(1).tail<kRow>().array() -= way;
        return D;
    }

    Positions m_X = slot(0.4);
    CurveBarrier m_barrier{segments(), m_X};
};

} // namespace

TEST_F(Slot, RestsWhereItWasBuilt) {
    EXPECT_EQ(energyAt(m_X), 0);
    EXPECT_EQ(m_barrier.edges(), segments());
}

TEST_F(Slot, RisesWithoutBoundAsTheGapCloses) {
    double last = 0;
    for (const double gap : {0.15, 0.1, 0.01, 1e-6}) {
        const double energy = energyAt(slot(gap));
        EXPECT_GT(energy, last) << gap;
        last = energy;
    }
}

TEST_F(Slot, IsInfiniteWhereAPointTouchesASegment) {
    Positions X = m_X;
    X.row(kRow) << 1.5, 0, 0;
    EXPECT_EQ(energyAt(X), std::numeric_limits<double>::infinity());
}

TEST_F(Slot, GradientAgreesWithFiniteDifferences) {
    const Positions X = slot(0.12) + 0.01 * Positions::Random(2 * kRow, 3);
    Positions gradient = Positions::Zero(X.rows(), 3);
    EXPECT_GT(m_barrier.energy(X, 1, gradient), 0.01);
    const Eigen::VectorXd numeric = test::finiteDifferences(
        [&](const Eigen::VectorXd& x) {
            return energyAt(Eigen::Map<const Positions>(x.data(), 2 * kRow, 3));
        },
        Eigen::Map<const Eigen::VectorXd>(X.data(), X.size()));
    const Eigen::VectorXd analytic = Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size());
    EXPECT_LT(test::relativeError(analytic, numeric), 1e-6);
    EXPECT_EQ(gradient.col(2).norm(), 0);
}

TEST_F(Slot, StopsBeforeACrossingAndKeepsAFifthAllTheWay) {
    const Positions D = closing(2);
    const double step = m_barrier.largestStep(m_X, D, 1);
    EXPECT_GT(step, 0.1);
    EXPECT_LT(step, 0.2); // they would meet at about 0.4 / 2
    for (int i = 0; i <= 100; ++i)
        EXPECT_GT(leastDistance(m_X + i / 100.0 * step * D), 0.2 * 0.4 * 0.99);
}

TEST_F(Slot, DoesNotStopWhatMovesTogetherOrApart) {
    const Positions together = Eigen::RowVector3d(7, -3, 1).replicate(2 * kRow, 1);
    EXPECT_EQ(m_barrier.largestStep(m_X, together, 1), 1);
    EXPECT_EQ(m_barrier.largestStep(m_X, closing(-2), 1), 1);
    EXPECT_EQ(m_barrier.largestStep(m_X, closing(0.1), 1), 1);
}

TEST(CurveBarrier, WithoutACurveThereIsNoLimit) {
    const Positions X = Positions::Random(4, 3);
    const CurveBarrier barrier({}, X);
    EXPECT_TRUE(barrier.empty());
    Positions gradient = Positions::Zero(4, 3);
    EXPECT_EQ(barrier.energy(X, 1, gradient), 0);
    EXPECT_EQ(barrier.largestStep(X, -5 * X, 0.7), 0.7);
}

TEST(SegmentDistance, FromInsideAndBeyondTheEnds) {
    const Eigen::Vector2d a(0, 0);
    const Eigen::Vector2d b(2, 0);
    EXPECT_DOUBLE_EQ(segmentDistance({0.5, 3}, a, b).distance, 3);
    EXPECT_DOUBLE_EQ(segmentDistance({0.5, 3}, a, b).t, 0.25);
    EXPECT_DOUBLE_EQ(segmentDistance({5, 4}, a, b).distance, 5);
    EXPECT_DOUBLE_EQ(segmentDistance({5, 4}, a, b).t, 1);
    EXPECT_DOUBLE_EQ(segmentDistance({-3, 4}, a, a).distance, 5);
}

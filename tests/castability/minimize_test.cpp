// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/minimize.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moldwright;

namespace {

double rosenbrock(const Eigen::VectorXd& x, Eigen::VectorXd& g) {
    const double a = 1 - x[0];
    const double b = x[1] - x[0] * x[0];
    g.resize(2);
    g << -2 * a - 400 * x[0] * b, 200 * b;
    return a * a + 100 * b * b;
}

/// Continuous, with a kink along x = 0 and y = 0.
double absolute(const Eigen::VectorXd& x, Eigen::VectorXd& g) {
    g.resize(2);
    g << (x[0] < 0 ? -1.0 : 1.0), (x[1] < 0 ? -3.0 : 3.0);
    return std::abs(x[0]) + 3 * std::abs(x[1]);
}

} // namespace

TEST(Minimize, LbfgsFindsTheValleyOfRosenbrock) {
    MinimizeOptions options;
    options.iterations = 200;
    const Minimum found = minimize(rosenbrock, Eigen::Vector2d(-1.2, 1), options);
    EXPECT_LT((found.x - Eigen::Vector2d(1, 1)).norm(), 1e-5);
}

TEST(Minimize, SubgradientDescentDecreasesANonsmoothFunction) {
    MinimizeOptions options;
    options.memory = 0;
    options.iterations = 100;
    EXPECT_LT(minimize(absolute, Eigen::Vector2d(1, 0.7), options).value, 0.05);
}

TEST(Minimize, LineSearchEndsWithTheWeakWolfeConditions) {
    const Eigen::Vector2d x(-1.2, 1);
    Eigen::VectorXd gradient;
    const double value = rosenbrock(x, gradient);
    const Eigen::VectorXd direction = -gradient;
    const LineSearch options;
    const LineSearchResult found =
        weakWolfeSearch(rosenbrock, x, value, gradient, direction, 1, 1e9, options);
    const double slope = gradient.dot(direction);
    EXPECT_LE(found.value, value + options.sufficientDecrease * found.step * slope);
    EXPECT_GE(found.gradient.dot(direction), options.curvature * slope);
}

TEST(Minimize, NeverStepsBeyondTheLimit) {
    double farthest = 0;
    const Objective slope = [&](const Eigen::VectorXd& x, Eigen::VectorXd& g) {
        farthest = std::max(farthest, x[0]);
        g = Eigen::VectorXd::Constant(1, -1);
        return -x[0];
    };
    MinimizeOptions options;
    options.iterations = 3;
    options.largestStep = [](const Eigen::VectorXd& x, const Eigen::VectorXd& d) {
        return (10 - x[0]) / 2 / d[0];
    };
    const Minimum found = minimize(slope, Eigen::VectorXd::Zero(1), options);
    EXPECT_LT(farthest, 10);
    EXPECT_NEAR(found.x[0], 8.75, 1e-12);
}

TEST(Minimize, InfinityIsSteppedBackFrom) {
    const Objective logarithm = [](const Eigen::VectorXd& x, Eigen::VectorXd& g) {
        g = Eigen::VectorXd::Constant(1, x[0] > 0 ? 1 - 0.01 / x[0] : 0);
        return x[0] > 0 ? x[0] - 0.01 * std::log(x[0]) : std::numeric_limits<double>::infinity();
    };
    MinimizeOptions options;
    const Minimum found = minimize(logarithm, Eigen::VectorXd::Constant(1, 5), options);
    EXPECT_NEAR(found.x[0], 0.01, 1e-6);
}

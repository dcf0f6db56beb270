// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <functional>

namespace moldwright {

/// A function to minimise: returns its value at x and writes a (sub)gradient there. May return infinity where
/// x is not allowed; the gradient is then not read.
using Objective = std::function<double(const Eigen::VectorXd& x, Eigen::VectorXd& gradient)>;

/// A step length for the weak Wolfe conditions by bisection and doubling; made for functions that are
/// continuous but only piecewise smooth. [Lewis 2013], Algorithm 2.6.
struct LineSearch {
    double sufficientDecrease = 1e-4; ///< c1
    double curvature = 0.9;           ///< c2
    int evaluations = 30;
};

/// Where a line search ended.
struct LineSearchResult {
    double step = 0; ///< 0: nothing better was found
    double value = 0;
    Eigen::VectorXd x;
    Eigen::VectorXd gradient;
};

/// Searches from x along `direction` (a descent direction) starting at `firstStep`, never beyond
/// `largestStep`.
[[nodiscard]] LineSearchResult weakWolfeSearch(const Objective& f, const Eigen::VectorXd& x, double value,
                                               const Eigen::VectorXd& gradient,
                                               const Eigen::VectorXd& direction, double firstStep,
                                               double largestStep, const LineSearch& options = {});

struct MinimizeOptions {
    int iterations = 100;
    int memory = 10;              ///< pairs that L-BFGS keeps; 0 is plain (sub)gradient descent
    double gradientTolerance = 0; ///< stop when the preconditioned decrease gᵀPg falls below its square
    double relativeDecrease = 0; ///< stop when ten iterations together gain less than this share of the value
    LineSearch lineSearch{};
    /// Applies an approximate inverse Hessian P to a vector; identity when empty.
    std::function<Eigen::VectorXd(const Eigen::VectorXd&)> precondition;
    /// Longest allowed step from x along a direction (e.g. before things collide); unlimited when empty.
    std::function<double(const Eigen::VectorXd& x, const Eigen::VectorXd& direction)> largestStep;
    /// Asked after each iteration with the current x and value; false ends the minimisation.
    std::function<bool(int iteration, const Eigen::VectorXd& x, double value)> proceed;
};

struct Minimum {
    Eigen::VectorXd x;
    double value = 0;
    int iterations = 0;
};

/// Limited-memory BFGS with the weak Wolfe search; with memory 0, subgradient descent. [Lewis 2013], [Nocedal
/// 1980].
[[nodiscard]] Minimum minimize(const Objective& f, Eigen::VectorXd x, const MinimizeOptions& options);

} // namespace moldwright

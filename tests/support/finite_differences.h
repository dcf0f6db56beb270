// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <functional>

namespace moldwright::test {

/// Central differences of f at x with step h: the gradient that an analytic one is held against.
inline Eigen::VectorXd finiteDifferences(const std::function<double(const Eigen::VectorXd&)>& f,
                                         Eigen::VectorXd x, double h = 1e-6) {
    Eigen::VectorXd gradient(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        const double at = x[i];
        x[i] = at + h;
        const double forward = f(x);
        x[i] = at - h;
        gradient[i] = (forward - f(x)) / (2 * h);
        x[i] = at;
    }
    return gradient;
}

/// Largest difference of two gradients over the larger of their norms.
inline double relativeError(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return (a - b).norm() / std::max({a.norm(), b.norm(), 1e-300});
}

} // namespace moldwright::test

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/minimize.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace moldwright {

namespace {

/// The curvature pairs of L-BFGS and the two-loop recursion over them.
class CurvaturePairs {
public:
    explicit CurvaturePairs(int memory) : m_memory(static_cast<std::size_t>(memory)) {}

    void clear() { m_pairs.clear(); }
    [[nodiscard]] bool empty() const { return m_pairs.empty(); }

    void add(Eigen::VectorXd s, Eigen::VectorXd y) {
        const double sy = s.dot(y);
        // A pair without clear positive curvature would spoil the positive definite model.
        if (m_memory == 0 || !(sy > 1e-12 * s.norm() * y.norm()))
            return;
        if (m_pairs.size() == m_memory)
            m_pairs.pop_front();
        m_pairs.push_back({std::move(s), std::move(y), 1 / sy});
    }

    [[nodiscard]] Eigen::VectorXd direction(const Eigen::VectorXd& gradient,
                                            const MinimizeOptions& options) const {
        Eigen::VectorXd q = -gradient;
        std::vector<double> alpha(m_pairs.size());
        for (std::size_t i = m_pairs.size(); i-- > 0;) {
            alpha[i] = m_pairs[i].rho * m_pairs[i].s.dot(q);
            q -= alpha[i] * m_pairs[i].y;
        }
        q = applyModel(q, options);
        for (std::size_t i = 0; i < m_pairs.size(); ++i)
            q += (alpha[i] - m_pairs[i].rho * m_pairs[i].y.dot(q)) * m_pairs[i].s;
        return q;
    }

private:
    struct Pair {
        Eigen::VectorXd s, y;
        double rho;
    };

    /// The initial inverse Hessian: the preconditioner, or the usual scaling by the newest pair.
    [[nodiscard]] Eigen::VectorXd applyModel(const Eigen::VectorXd& q, const MinimizeOptions& options) const {
        if (options.precondition)
            return options.precondition(q);
        if (m_pairs.empty())
            return q;
        const Pair& newest = m_pairs.back();
        return q * (1 / (newest.rho * newest.y.squaredNorm()));
    }

    std::size_t m_memory;
    std::deque<Pair> m_pairs;
};

} // namespace

LineSearchResult weakWolfeSearch(const Objective& f, const Eigen::VectorXd& x, double value,
                                 const Eigen::VectorXd& gradient, const Eigen::VectorXd& direction,
                                 double firstStep, double largestStep, const LineSearch& options) {
    const double slope = gradient.dot(direction);
    LineSearchResult best{0, value, x, gradient};
    if (!(slope < 0))
        return best;
    LineSearchResult trial;
    double low = 0;
    double high = std::numeric_limits<double>::infinity();
    double step = std::min(firstStep, largestStep);
    for (int i = 0; i < options.evaluations; ++i) {
        trial.step = step;
        trial.x = x + step * direction;
        trial.value = f(trial.x, trial.gradient);
        const bool decreased = trial.value <= value + options.sufficientDecrease * step * slope;
        if (!decreased) {
            high = step;
        } else {
            if (trial.value < best.value)
                best = trial;
            if (trial.gradient.dot(direction) >= options.curvature * slope || step >= largestStep)
                return trial;
            low = step;
        }
        step = std::isinf(high) ? std::min(2 * step, largestStep) : 0.5 * (low + high);
        if (!(high - low > 1e-14 * high) && !std::isinf(high))
            break;
    }
    return best;
}

Minimum minimize(const Objective& f, Eigen::VectorXd x, const MinimizeOptions& options) {
    CurvaturePairs pairs(options.memory);
    Eigen::VectorXd gradient(x.size());
    double value = f(x, gradient);
    std::deque<double> history{value};
    int iteration = 0;
    while (iteration < options.iterations) {
        Eigen::VectorXd direction = pairs.direction(gradient, options);
        double slope = gradient.dot(direction);
        if (!(slope < 0) && !pairs.empty()) {
            pairs.clear();
            direction = pairs.direction(gradient, options);
            slope = gradient.dot(direction);
        }
        if (!(-slope > options.gradientTolerance * options.gradientTolerance))
            break;
        // Without scale information a first plain gradient step of unit length is as good as any.
        const bool scaled = options.precondition || !pairs.empty();
        const double first = scaled ? 1.0 : 1.0 / std::max(1.0, direction.norm());
        const double largest =
            options.largestStep ? options.largestStep(x, direction) : std::numeric_limits<double>::infinity();
        LineSearchResult found =
            weakWolfeSearch(f, x, value, gradient, direction, first, largest, options.lineSearch);
        if (found.step == 0) {
            if (pairs.empty())
                break;
            pairs.clear();
            continue;
        }
        pairs.add(found.x - x, found.gradient - gradient);
        x = std::move(found.x);
        gradient = std::move(found.gradient);
        value = found.value;
        ++iteration;
        if (options.proceed && !options.proceed(iteration, x, value))
            break;
        history.push_back(value);
        if (history.size() > 10) {
            const double gained = history.front() - value;
            history.pop_front();
            if (gained <= options.relativeDecrease * std::abs(value))
                break;
        }
    }
    return {std::move(x), value, iteration};
}

} // namespace moldwright

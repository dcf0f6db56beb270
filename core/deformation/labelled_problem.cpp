// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/labelled_problem.h"

#include "castability/minimize.h"
#include "castability/parting_line.h"
#include "deformation/side_hinge.h"

namespace moldwright {

namespace {

Positions unflatten(const Eigen::VectorXd& x) {
    return Eigen::Map<const Positions>(x.data(), x.size() / 3, 3);
}

Eigen::VectorXd flatten(const Positions& X) {
    return Eigen::Map<const Eigen::VectorXd>(X.data(), X.size());
}

/// +1 or −1 for points whose faces are all on that side, 0 for points of the parting line, those that do not
/// move, and inner points.
std::vector<signed char> sidesOfPoints(const LabelledBody& body) {
    std::vector<signed char> side(static_cast<std::size_t>(body.shape.V.rows()), 0);
    for (Eigen::Index f = 0; f < body.shape.F.rows(); ++f)
        for (int k = 0; k < 3; ++k) {
            const int v = body.shape.F(f, k);
            const bool moves = body.fixed.empty() || !body.fixed[static_cast<std::size_t>(v)];
            if (moves && !body.held[static_cast<std::size_t>(v)])
                side[static_cast<std::size_t>(v)] = body.labels[static_cast<std::size_t>(f)] == 1 ? 1 : -1;
        }
    return side;
}

std::vector<std::array<int, 2>> curveOf(const LabelledBody& body) {
    return !body.line.empty() ? body.line
                              : partingEdges(IndexedMesh{body.shape.V, body.shape.F}, body.labels);
}

} // namespace

LabelledProblem::LabelledProblem(LabelledBody body)
    : m_body(std::move(body)), m_elastic(m_body.shape), m_barrier(curveOf(m_body), m_body.shape.V),
      m_heights(sidesOfPoints(m_body), m_body.shape.V), m_bodyLaplacian(m_elastic.laplacian()),
      // A sum keeps the union of both patterns: from here on one pattern serves for any weights.
      m_surfaceLaplacian(0.0 * m_bodyLaplacian + surfaceLaplacian(m_body.shape.V, m_body.shape.F)),
      m_system(m_surfaceLaplacian, m_body.held, m_body.fixed) {
    m_bodyLaplacian = m_bodyLaplacian + 0.0 * m_surfaceLaplacian;
}

double LabelledProblem::value(const StageWeights& weights, const std::vector<double>& faceWeights,
                              const Positions& X, Positions& gradient) const {
    gradient = Positions::Zero(X.rows(), 3);
    double value = 0;
    if (weights.elastic > 0)
        value += weights.elastic * m_elastic.energy(X, weights.elastic, gradient);
    const SideHinge hinge{m_body.shape.F, m_body.labels, m_body.directions, weights.tau, faceWeights};
    value += weights.hinge * hinge.energy(X, weights.hinge, gradient);
    if (weights.barrier > 0)
        value += weights.barrier * m_barrier.energy(X, weights.barrier, gradient);
    for (std::size_t v = 0; v < m_body.held.size(); ++v)
        if (m_body.held[v])
            gradient(static_cast<Eigen::Index>(v), 2) = 0;
    for (std::size_t v = 0; v < m_body.fixed.size(); ++v)
        if (m_body.fixed[v])
            gradient.row(static_cast<Eigen::Index>(v)).setZero();
    return value;
}

double LabelledProblem::largestStep(const Positions& X, const Positions& D) const {
    return m_barrier.largestStep(X, D, 1);
}

Positions LabelledProblem::minimize(const StageWeights& weights, const std::vector<double>& faceWeights,
                                    Positions X, const std::function<bool(const Positions&)>& watch) {
    const Eigen::SparseMatrix<double> model =
        2 * weights.elastic * m_bodyLaplacian + weights.hinge * m_surfaceLaplacian;
    if (!m_system.factor(model))
        return X;
    MinimizeOptions options;
    options.iterations = weights.iterations;
    options.relativeDecrease = weights.relativeDecrease;
    options.precondition = [&](const Eigen::VectorXd& g) { return flatten(m_system.solve(unflatten(g))); };
    options.largestStep = [&](const Eigen::VectorXd& x, const Eigen::VectorXd& d) {
        return largestStep(unflatten(x), unflatten(d));
    };
    options.proceed = [&](int, const Eigen::VectorXd& u, double) {
        return watch(m_heights.toPositions(unflatten(u)));
    };
    const Objective objective = [&](const Eigen::VectorXd& u, Eigen::VectorXd& g) {
        const Positions U = unflatten(u);
        Positions gradient;
        const double f = value(weights, faceWeights, m_heights.toPositions(U), gradient);
        m_heights.pullBack(U, gradient);
        g = flatten(gradient);
        return f;
    };
    const Minimum found = moldwright::minimize(objective, flatten(m_heights.toFree(std::move(X))), options);
    m_iterations += found.iterations;
    return m_heights.toPositions(unflatten(found.x));
}

} // namespace moldwright

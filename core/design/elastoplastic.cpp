// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/elastoplastic.h"

#include "castability/directions.h"
#include "castability/energy.h"
#include "castability/minimize.h"
#include "deformation/tet_topology.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr double kSettled = 1e-12; ///< mean square motion that ends a step early, working units
constexpr int kPostIterations = 200;
/// 1 for the points that pins hold.
std::vector<char> heldIn(const WorkingBody& body) {
    std::vector<char> held(static_cast<std::size_t>(body.shape.V.rows()), 0);
    for (const int v : body.pinned)
        held[static_cast<std::size_t>(v)] = 1;
    return held;
}

} // namespace

Result<Elastoplastic> Elastoplastic::create(const IndexedMesh& part, const MoldState& state,
                                            const ElastoplasticSettings& settings, const Task& task,
                                            const std::vector<Pin>& pins,
                                            const std::vector<double>& faceWeights) {
    Result<WorkingBody> body = workingBody(part, state, pins, faceWeights, task);
    if (!body)
        return std::unexpected(body.error());
    return Elastoplastic(std::move(*body), state, settings);
}

Elastoplastic::Elastoplastic(WorkingBody body, const MoldState& state, const ElastoplasticSettings& settings)
    : m_body(std::move(body)), m_state(state), m_settings(settings),
      m_solver(m_body.shape, heldIn(m_body), settings.smoothing) {}

void Elastoplastic::change(const ElastoplasticSettings& settings, const Directions& directions) {
    m_settings = settings;
    m_state.directions = directions;
    m_solver.setSmoothing(settings.smoothing);
}

void Elastoplastic::setFaceWeights(const std::vector<double>& faceWeights) {
    m_solver.setTetWeights(faceWeights.empty() ? std::vector<double>()
                                               : tetWeights(m_solver.shape().T, m_body.shape.F, faceWeights));
}

/// Faces that cross the plane get no side: post-processing takes care of them.
SideLabels Elastoplastic::sides() const {
    SideLabels sides(static_cast<std::size_t>(m_body.shape.F.rows()), 0);
    for (Eigen::Index f = 0; f < m_body.shape.F.rows(); ++f) {
        const auto z = [&](int k) { return m_solver.positions()(m_body.shape.F(f, k), 2); };
        const double low = std::min({z(0), z(1), z(2)});
        const double high = std::max({z(0), z(1), z(2)});
        sides[static_cast<std::size_t>(f)] = low >= 0 ? 1 : high <= 0 ? 2 : 0;
    }
    return sides;
}

void Elastoplastic::step(const Task& task) {
    if (m_settings.optimizeDirections)
        m_state.directions =
            bestDirections(shape(), m_state.plane, m_settings.draftDegrees, m_settings.limits);
    const Directions directions = m_body.frame.directionsToWork(m_state.directions);
    const double tau = std::sin(radians(m_settings.draftDegrees));
    for (int i = 0; i < m_settings.iterationsPerStep && !task.stopped(); ++i) {
        ++m_iterations;
        if (m_solver.iterate(sides(), directions, tau) < kSettled)
            break;
    }
    m_solver.restart();
    ++m_steps;
}

IndexedMesh postProcess(const IndexedMesh& shape, const MoldState& state, double draftDegrees,
                        const Task& task, const std::vector<PlacedPin>& pins) {
    IndexedMesh moving = shape;
    const double tau = std::sin(radians(draftDegrees));
    const Objective energy = [&](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
        moving.V = Eigen::Map<const Points>(x.data(), shape.V.rows(), 3);
        Points g;
        const double value = castabilityEnergy(moving, state, tau, g);
        const Eigen::Vector3d& n = state.plane.normal;
        for (const PlacedPin& pin : pins)
            if (pin.surfacePoint >= 0)
                g.row(pin.surfacePoint) -= g.row(pin.surfacePoint).dot(n) * n.transpose();
        gradient = Eigen::Map<const Eigen::VectorXd>(g.data(), g.size());
        return value;
    };
    MinimizeOptions options;
    options.iterations = kPostIterations;
    options.relativeDecrease = 1e-6;
    options.proceed = [&](int, const Eigen::VectorXd&, double) { return !task.stopped(); };
    const Minimum found =
        minimize(energy, Eigen::Map<const Eigen::VectorXd>(shape.V.data(), shape.V.size()), options);
    moving.V = Eigen::Map<const Points>(found.x.data(), shape.V.rows(), 3);
    return moving;
}

} // namespace moldwright

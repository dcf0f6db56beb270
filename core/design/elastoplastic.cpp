// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/elastoplastic.h"

#include "castability/directions.h"
#include "castability/energy.h"
#include "castability/minimize.h"
#include "deformation/pin_drawing.h"
#include "deformation/tet_topology.h"
#include "exchange/tetrahedralize.h"
#include "mesh/closest_point.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr double kSettled = 1e-12; ///< mean square motion that ends a step early, working units
constexpr int kPostIterations = 200;
constexpr double kOnSurface = 1e-3; ///< working units: pins no deeper hold a point of the surface

BodyShape bodyOf(const IndexedMesh& surface, const TetMesh& tets) {
    BodyShape body;
    body.V = tets.V;
    body.T = tets.T;
    body.F = surface.F;
    return body;
}

int nearestPoint(const Points& V, const Eigen::Vector3d& p) {
    Eigen::Index nearest = 0;
    (V.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    return static_cast<int>(nearest);
}

/// The pins (working frame) that want a point of their own: those near a point of the surface take that.
Points pinsInside(const IndexedMesh& work, const std::vector<Pin>& pins, const WorkingFrame& frame) {
    Points inside(static_cast<Eigen::Index>(pins.size()), 3);
    Eigen::Index count = 0;
    const ClosestPoint surface(work);
    for (const Pin& pin : pins) {
        const Eigen::Vector3d p = frame.toWork(pin.point);
        bool again = false;
        for (Eigen::Index i = 0; i < count; ++i)
            again = again || inside.row(i) == p.transpose();
        if (!again && surface.distance(p) > kOnSurface)
            inside.row(count++) = p.transpose();
    }
    inside.conservativeResize(count, Eigen::NoChange);
    return inside;
}

} // namespace

Result<Elastoplastic> Elastoplastic::create(SharedMesh part, const MoldState& state,
                                            const ElastoplasticSettings& settings, const Task& task,
                                            const std::vector<Pin>& pins) {
    const WorkingFrame frame(*part, state);
    const IndexedMesh work = frame.toWork(*part);
    Result<TetMesh> tets = tetrahedralize(work, task, kTetGenSwitches, pinsInside(work, pins, frame));
    if (!tets)
        return std::unexpected(tets.error());
    return Elastoplastic(std::move(part), state, settings, frame, bodyOf(work, *tets));
}

Elastoplastic::Elastoplastic(SharedMesh part, const MoldState& state, const ElastoplasticSettings& settings,
                             WorkingFrame frame, BodyShape body)
    : m_part(std::move(part)), m_state(state), m_settings(settings), m_frame(std::move(frame)),
      m_undeformed(body.V),
      m_solver(std::move(body), std::vector<char>(static_cast<std::size_t>(m_undeformed.rows()), 0),
               settings.smoothing) {}

void Elastoplastic::setPins(const std::vector<Pin>& pins) {
    std::vector<char> held(static_cast<std::size_t>(m_undeformed.rows()), 0);
    m_pinned.clear();
    for (const Pin& pin : pins) {
        m_pinned.push_back(nearestPoint(m_undeformed, m_frame.toWork(pin.point)));
        held[static_cast<std::size_t>(m_pinned.back())] = 1;
    }
    m_solver.setHeld(std::move(held));
}

void Elastoplastic::drawPins(const Task& task) {
    m_solver.setPositions(drawnIntoPlane(m_solver.shape(), m_pinned, task));
    m_solver.restart();
}

std::vector<PlacedPin> Elastoplastic::pins() const {
    std::vector<PlacedPin> pins;
    for (const int v : m_pinned)
        pins.push_back({m_frame.toPart(Eigen::Vector3d(m_solver.positions().row(v))),
                        v < m_part->vertexCount() ? v : -1});
    return pins;
}

void Elastoplastic::change(const ElastoplasticSettings& settings, const Directions& directions) {
    m_settings = settings;
    m_state.directions = directions;
    m_solver.setSmoothing(settings.smoothing);
}

void Elastoplastic::setFaceWeights(const std::vector<double>& faceWeights) {
    m_solver.setTetWeights(faceWeights.empty() ? std::vector<double>()
                                               : tetWeights(m_solver.shape().T, m_part->F, faceWeights));
}

/// Faces that cross the plane get no side: post-processing takes care of them.
SideLabels Elastoplastic::sides() const {
    SideLabels sides(static_cast<std::size_t>(m_part->faceCount()), 0);
    for (int f = 0; f < m_part->faceCount(); ++f) {
        const auto z = [&](int k) { return m_solver.positions()(m_part->F(f, k), 2); };
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
    const Directions directions = m_frame.directionsToWork(m_state.directions);
    const double tau = std::sin(radians(m_settings.draftDegrees));
    for (int i = 0; i < m_settings.iterationsPerStep && !task.stopped(); ++i) {
        ++m_iterations;
        if (m_solver.iterate(sides(), directions, tau) < kSettled)
            break;
    }
    m_solver.restart();
    ++m_steps;
}

IndexedMesh Elastoplastic::shape() const {
    return m_frame.toPart(
        IndexedMesh{Points(m_solver.positions().topRows(m_part->vertexCount())), m_part->F});
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

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/local_global.h"

#include "base/parallel.h"
#include "deformation/side_hinge.h"
#include "deformation/tet_topology.h"

#include <algorithm>
#include <utility>

namespace moldwright {

namespace {

constexpr std::size_t kGrain = 512;

} // namespace

LocalGlobal::LocalGlobal(BodyShape shape, std::vector<char> held, double smoothing)
    : m_shape(std::move(shape)), m_held(std::move(held)), m_smoothing(smoothing), m_body(m_shape),
      m_neighbours(m_body, tetNeighbours(m_shape.T)), m_system(m_body.laplacian(), m_held), m_X(m_shape.V) {
    listLanesOfFaces();
    prepare();
}

void LocalGlobal::listLanesOfFaces() {
    const std::vector<int> behind = tetsBehindFaces(m_shape.T, m_shape.F);
    for (int f = 0; f < static_cast<int>(behind.size()); ++f) {
        if (const int tet = behind[static_cast<std::size_t>(f)]; tet >= 0)
            m_lanesOfFaces.push_back({m_body.laneOf(tet), f});
        if (m_body.faceCount() > 0)
            m_lanesOfFaces.push_back({m_body.laneOf(m_body.tetCount() + f), f});
    }
    std::stable_sort(m_lanesOfFaces.begin(), m_lanesOfFaces.end(),
                     [](const LaneOfFace& a, const LaneOfFace& b) { return a.lane < b.lane; });
}

void LocalGlobal::prepare() {
    m_restNormals.resize(m_shape.F.rows(), 3);
    for (Eigen::Index f = 0; f < m_shape.F.rows(); ++f) {
        Eigen::Vector3d x[3];
        for (int k = 0; k < 3; ++k)
            x[k] = m_shape.V.row(m_shape.F(f, k)).transpose();
        m_restNormals.row(f) = (x[1] - x[0]).cross(x[2] - x[0]).normalized().transpose();
    }
    (void)m_system.factor(m_body.laplacian());
}

double LocalGlobal::iterate(const SideLabels& sides, const Directions& directions, double tau) {
    m_body.fit(m_X, m_rotations);
    enforce(sides, directions, tau);
    if (m_smoothing > 0) {
        m_neighbours.apply(m_rotations, m_smoothing, m_smoothed);
        std::swap(m_rotations, m_smoothed);
    }
    // The shift holds the singular directions (motion in the plane) at the present place: the centroid stays.
    Positions next = m_system.solve(m_body.rightHandSide(m_rotations) + m_system.shift() * m_X);
    const double motion = (next - m_X).squaredNorm() / static_cast<double>(next.rows());
    m_X = std::move(next);
    return motion;
}

void LocalGlobal::enforce(const SideLabels& sides, const Directions& directions, double tau) {
    parallelFor(m_lanesOfFaces.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        // The faces of one element belong to the block where the first of them lies.
        const auto startsElement = [&](std::size_t i) {
            return i == 0 || i >= m_lanesOfFaces.size() ||
                   m_lanesOfFaces[i].lane != m_lanesOfFaces[i - 1].lane;
        };
        while (begin < end && !startsElement(begin))
            ++begin;
        while (begin < end && !startsElement(end))
            ++end;
        for (std::size_t i = begin; i < end; ++i) {
            const auto [lane, face] = m_lanesOfFaces[i];
            const int side = sides[static_cast<std::size_t>(face)];
            if (side == 0)
                continue;
            // An element with several violating faces is turned for one after the other.
            const Eigen::Quaterniond R = rotationAt(m_rotations, lane);
            const Eigen::Vector3d N = R * m_restNormals.row(face).transpose();
            if (N.dot(directions.of(side)) < tau)
                setRotation(m_rotations, lane, castableRotation(N, directions.of(side), tau) * R);
        }
    });
}

void LocalGlobal::restart() {
    m_shape.V = m_X;
    m_body.setRest(m_shape.V, m_shape.tetWeights);
    prepare();
}

void LocalGlobal::setHeld(std::vector<char> held) {
    m_held = std::move(held);
    m_system = PlaneSystem(m_body.laplacian(), m_held);
    prepare();
}

void LocalGlobal::setTetWeights(std::vector<double> weights) {
    m_shape.tetWeights = std::move(weights);
    m_body.setRest(m_shape.V, m_shape.tetWeights);
    prepare();
}

} // namespace moldwright

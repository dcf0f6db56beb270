// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/local_global.h"

#include "base/parallel.h"
#include "deformation/side_hinge.h"
#include "deformation/tet_topology.h"

#include <utility>

namespace moldwright {

namespace {

constexpr std::size_t kGrain = 2048;

} // namespace

LocalGlobal::LocalGlobal(BodyShape shape, std::vector<char> held, double smoothing)
    : m_shape(std::move(shape)), m_held(std::move(held)), m_smoothing(smoothing),
      m_body(std::make_unique<ElasticBody>(m_shape)), m_system(m_body->laplacian(), m_held), m_X(m_shape.V),
      m_tetOfFace(tetsBehindFaces(m_shape.T, m_shape.F)), m_neighbours(tetNeighbours(m_shape.T)) {
    prepare();
}

void LocalGlobal::prepare() {
    (void)m_system.factor(m_body->laplacian());
}

double LocalGlobal::iterate(const SideLabels& sides, const Directions& directions, double tau) {
    m_body->fit(m_X, m_rotations);
    enforce(sides, directions, tau);
    if (m_smoothing > 0)
        smooth();
    // The shift holds the singular directions (motion in the plane) at the present place: the centroid stays.
    const Positions next = m_system.solve(m_body->rightHandSide(m_rotations) + m_system.shift() * m_X);
    const double motion = (next - m_X).squaredNorm() / static_cast<double>(next.rows());
    m_X = next;
    return motion;
}

void LocalGlobal::enforce(const SideLabels& sides, const Directions& directions, double tau) {
    for (Eigen::Index f = 0; f < m_shape.F.rows(); ++f) {
        const int side = sides[static_cast<std::size_t>(f)];
        if (side == 0)
            continue;
        Eigen::Vector3d x[3];
        for (int k = 0; k < 3; ++k)
            x[k] = m_shape.V.row(m_shape.F(f, k)).transpose();
        const Eigen::Vector3d restNormal = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
        const auto turn = [&](Eigen::Matrix3d& R) {
            R = castableRotation(R * restNormal, directions.of(side), tau) * R;
        };
        // A tetrahedron with several violating faces is turned for one after the other.
        if (const int tet = m_tetOfFace[static_cast<std::size_t>(f)]; tet >= 0)
            turn(m_rotations[static_cast<std::size_t>(tet)]);
        if (m_body->faceCount() > 0)
            turn(m_rotations[static_cast<std::size_t>(m_body->tetCount() + f)]);
    }
}

void LocalGlobal::smooth() {
    std::vector<Eigen::Quaterniond> q(static_cast<std::size_t>(m_body->tetCount()));
    parallelFor(q.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t)
            q[t] = Eigen::Quaterniond(m_rotations[t]);
    });
    parallelFor(q.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            Eigen::Vector4d sum = Eigen::Vector4d::Zero();
            int count = 0;
            for (const int u : m_neighbours[t]) {
                if (u < 0)
                    continue;
                const Eigen::Vector4d other = q[static_cast<std::size_t>(u)].coeffs();
                sum += other.dot(q[t].coeffs()) < 0 ? Eigen::Vector4d(-other) : other;
                ++count;
            }
            if (count == 0)
                continue;
            const Eigen::Vector4d blend = (1 - m_smoothing) * q[t].coeffs() + m_smoothing / count * sum;
            m_rotations[t] = Eigen::Quaterniond(blend.normalized()).toRotationMatrix();
        }
    });
}

void LocalGlobal::restart() {
    m_shape.V = m_X;
    m_body = std::make_unique<ElasticBody>(m_shape);
    prepare();
}

void LocalGlobal::setHeld(std::vector<char> held) {
    m_held = std::move(held);
    m_system = PlaneSystem(m_body->laplacian(), m_held);
    prepare();
}

void LocalGlobal::setTetWeights(std::vector<double> weights) {
    m_shape.tetWeights = std::move(weights);
    m_body = std::make_unique<ElasticBody>(m_shape);
    prepare();
}

} // namespace moldwright

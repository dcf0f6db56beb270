// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/directions.h"

#include "castability/energy.h"
#include "castability/minimize.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

Eigen::Vector3d bestOfSide(const SideFaces& faces, const Eigen::Vector3d& axis, double tau,
                           double maxTiltDegrees) {
    const ConeDirection cone(axis, maxTiltDegrees);
    const Objective energy = [&](const Eigen::VectorXd& c, Eigen::VectorXd& gradient) {
        Eigen::Vector3d g;
        const double value = sideEnergy(faces, cone.direction(c), tau, &g);
        gradient = cone.pullBack(c, g);
        return value;
    };
    MinimizeOptions options;
    options.iterations = 40;
    options.relativeDecrease = 1e-6;
    const Minimum best = minimize(energy, Eigen::Vector2d::Zero(), options);
    // The normal itself is the natural choice: leave it only for a real gain.
    const double atNormal = sideEnergy(faces, axis, tau);
    return best.value < atNormal * (1 - 1e-9) ? cone.direction(best.x) : axis;
}

} // namespace

void SideFaces::add(const Eigen::Vector3d& N, double a) {
    nx.push_back(N.x());
    ny.push_back(N.y());
    nz.push_back(N.z());
    area.push_back(a);
}

PartedFaces partFaces(const IndexedMesh& mesh, const PartingPlane& plane) {
    PartedFaces parted;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const Eigen::Vector3d c = doubleAreaVector(mesh, f);
        const double length = c.norm();
        if (!(length > 0))
            continue;
        const Eigen::Vector3d N = c / length;
        Eigen::Vector3d distances;
        for (int k = 0; k < 3; ++k)
            distances[k] = plane.distance(mesh.corner(f, k));
        const double share1 = partArea(distances, N.dot(plane.normal) > 0 ? 1 : 2).share1;
        if (share1 > 0)
            parted.side1.add(N, length / 2 * share1);
        if (share1 < 1)
            parted.side2.add(N, length / 2 * (1 - share1));
    }
    return parted;
}

double sideEnergy(const SideFaces& faces, const Eigen::Vector3d& d, double tau, Eigen::Vector3d* gradient) {
    double energy = 0;
    double gx = 0;
    double gy = 0;
    double gz = 0;
    const double dx = d.x();
    const double dy = d.y();
    const double dz = d.z();
    for (std::size_t i = 0; i < faces.area.size(); ++i) {
        const double h = std::min(faces.nx[i] * dx + faces.ny[i] * dy + faces.nz[i] * dz - tau, 0.0);
        const double ha = h * faces.area[i];
        energy += h * ha;
        gx += ha * faces.nx[i];
        gy += ha * faces.ny[i];
        gz += ha * faces.nz[i];
    }
    if (gradient)
        *gradient << gx, gy, gz;
    return energy / 2;
}

ConeDirection::ConeDirection(const Eigen::Vector3d& axis, double maxTiltDegrees)
    : m_axis(axis), m_reach(std::tan(radians(maxTiltDegrees))) {
    const auto [x, y] = planeAxes(axis);
    m_tangents << x, y;
}

Eigen::Vector3d ConeDirection::direction(const Eigen::Vector2d& c) const {
    return (m_axis + m_reach / std::sqrt(1 + c.squaredNorm()) * (m_tangents * c)).normalized();
}

Eigen::Vector2d ConeDirection::pullBack(const Eigen::Vector2d& c, const Eigen::Vector3d& g) const {
    const double root = std::sqrt(1 + c.squaredNorm());
    const Eigen::Vector3d unnormalized = m_axis + m_reach / root * (m_tangents * c);
    const Eigen::Vector3d d = unnormalized.normalized();
    const Eigen::Vector3d gUnnormalized = (g - d * d.dot(g)) / unnormalized.norm();
    const Eigen::Vector2d gTangent = m_reach * (m_tangents.transpose() * gUnnormalized);
    return gTangent / root - c * c.dot(gTangent) / (root * root * root);
}

Eigen::Vector2d ConeDirection::coordinates(const Eigen::Vector3d& d) const {
    if (!(m_reach > 0))
        return Eigen::Vector2d::Zero();
    Eigen::Vector2d u = m_tangents.transpose() * d / std::max(d.dot(m_axis), 1e-9) / m_reach;
    // Just inside the rim, so that c stays moderate and the gradient alive.
    const double length = u.norm();
    if (length > 0.98)
        u *= 0.98 / length;
    return u / std::sqrt(1 - u.squaredNorm());
}

Directions bestDirections(const IndexedMesh& mesh, const PartingPlane& plane, double draftDegrees,
                          double maxTiltDegrees) {
    const PartedFaces parted = partFaces(mesh, plane);
    const double tau = std::sin(radians(draftDegrees));
    return {bestOfSide(parted.side1, plane.normal, tau, maxTiltDegrees),
            bestOfSide(parted.side2, -plane.normal, tau, maxTiltDegrees)};
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "pins/unit_part.h"

#include "mesh/measures.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace moldwright {

namespace {

constexpr double kGrid = 1e-7;

Eigen::Vector3d middle(const IndexedMesh& mesh, int f) {
    return (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
}

/// Right-handed; the first two point to where more of the surface lies far out.
Eigen::Matrix3d principalAxes(const IndexedMesh& part, const Eigen::Vector3d& centre) {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (int f = 0; f < part.faceCount(); ++f) {
        const Eigen::Vector3d p = middle(part, f) - centre;
        spread += doubleAreaVector(part, f).norm() * p * p.transpose();
    }
    Eigen::Matrix3d axes =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread / spread.trace()).eigenvectors();
    for (int k = 0; k < 2; ++k) {
        double lean = 0;
        for (int f = 0; f < part.faceCount(); ++f)
            lean += doubleAreaVector(part, f).norm() * std::pow(axes.col(k).dot(middle(part, f) - centre), 3);
        if (lean < 0)
            axes.col(k) *= -1;
    }
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return axes;
}

} // namespace

UnitPart::UnitPart(const IndexedMesh& part) : mesh(part), centre(Eigen::Vector3d::Zero()) {
    double area = 0;
    for (int f = 0; f < part.faceCount(); ++f) {
        const double a = doubleAreaVector(part, f).norm();
        area += a;
        centre += a * middle(part, f);
    }
    centre /= area;
    axes = principalAxes(part, centre);
    const Points away = part.V.rowwise() - centre.transpose();
    size = 2 * away.rowwise().norm().maxCoeff();
    mesh.V = ((away * axes / (kGrid * size)).array().round() * kGrid).matrix();
}

} // namespace moldwright

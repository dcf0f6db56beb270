// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/side_hinge.h"

#include "base/parallel.h"

#include <Eigen/Geometry>

namespace moldwright {

namespace {

constexpr std::size_t kGrain = 1024;

struct Face {
    Eigen::Vector3d x[3];
    Eigen::Vector3d N;
    double doubleArea = 0;
};

Face faceAt(const Triangles& F, Eigen::Index f, const Positions& X) {
    Face face;
    for (int k = 0; k < 3; ++k)
        face.x[k] = X.row(F(f, k)).transpose();
    const Eigen::Vector3d c = (face.x[1] - face.x[0]).cross(face.x[2] - face.x[0]);
    face.doubleArea = c.norm();
    face.N = face.doubleArea > 0 ? Eigen::Vector3d(c / face.doubleArea) : Eigen::Vector3d::Zero();
    return face;
}

} // namespace

double SideHinge::energy(const Positions& X, double factor, Positions& gradient) const {
    const auto faces = static_cast<std::size_t>(F.rows());
    // What each face does to its corners; scattered afterwards, in face order.
    std::vector<Eigen::Matrix3d> pushes(faces);
    std::vector<char> pushing(faces, 0);
    const double energy = parallelSum<double>(faces, kGrain, 0.0, [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t f = begin; f < end; ++f) {
            const Face face = faceAt(F, static_cast<Eigen::Index>(f), X);
            const Eigen::Vector3d& d = directions.of(labels[f]);
            const double h = face.N.dot(d) - tau;
            if (h >= 0 || !(face.doubleArea > 0))
                continue;
            sum += 0.5 * weights[f] * h * h;
            pushing[f] = 1;
            for (int k = 0; k < 3; ++k) {
                const Eigen::Vector3d opposite = face.x[(k + 2) % 3] - face.x[(k + 1) % 3];
                pushes[f].col(k) =
                    factor * weights[f] * h * d.dot(opposite.cross(face.N)) / face.doubleArea * face.N;
            }
        }
        return sum;
    });
    for (std::size_t f = 0; f < faces; ++f)
        if (pushing[f])
            for (int k = 0; k < 3; ++k)
                gradient.row(F(static_cast<Eigen::Index>(f), k)) += pushes[f].col(k).transpose();
    return energy;
}

SideDraft sideDraft(const Triangles& F, const SideLabels& labels, const Directions& directions,
                    const Positions& X, double tau) {
    SideDraft draft;
    for (Eigen::Index f = 0; f < F.rows(); ++f) {
        const Face face = faceAt(F, f, X);
        const double sine = face.N.dot(directions.of(labels[static_cast<std::size_t>(f)]));
        draft.worstSine = std::min(draft.worstSine, sine);
        if (sine < tau) {
            ++draft.violating;
            draft.violatingArea += face.doubleArea / 2;
        }
    }
    return draft;
}

Eigen::Quaterniond castableRotation(const Eigen::Vector3d& N, const Eigen::Vector3d& d, double tau) {
    const double cosine = N.dot(d);
    if (cosine >= tau)
        return Eigen::Quaterniond::Identity();
    Eigen::Vector3d axis = N.cross(d);
    const double sine = axis.norm();
    axis = sine > 1e-9 ? Eigen::Vector3d(axis / sine) : planeAxes(d)[0];
    const double angle = std::atan2(sine, cosine) - std::acos(tau);
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/best_place.h"

#include <Eigen/Geometry>

#include <limits>

namespace moldwright {

namespace {

constexpr int kCuts =
    90; ///< each takes a sixth of the volume left: less than a hundredth of the reach remains

struct Spare {
    double value;
    Eigen::Vector3d gradient;
};

/// What the worst face has to spare with its point at x, and how that grows with x.
Spare worstSpare(std::span<const FaceToPlace> faces, const Eigen::Vector3d& x, double tau) {
    Spare worst{std::numeric_limits<double>::infinity(), Eigen::Vector3d::Zero()};
    for (const FaceToPlace& face : faces) {
        const Eigen::Vector3d edge = face.b - face.a;
        const double length = edge.norm();
        if (length == 0)
            continue;
        const Eigen::Vector3d c = (face.a - x).cross(edge);
        const double size = c.norm();
        const double value = (c.dot(face.direction) - tau * size) / length;
        if (value >= worst.value)
            continue;
        const Eigen::Vector3d pull =
            size > 0 ? Eigen::Vector3d(face.direction - tau / size * c) : face.direction;
        worst = {value, pull.cross(edge) / length};
    }
    return worst;
}

} // namespace

Eigen::Vector3d bestPlace(std::span<const FaceToPlace> faces, const Eigen::Vector3d& start,
                          const PlaceBounds& bounds, double tau) {
    constexpr double n = 3;
    Eigen::Matrix3d shape = Eigen::Matrix3d::Identity() * (bounds.reach * bounds.reach);
    Eigen::Vector3d x = start;
    Eigen::Vector3d best = start;
    double most = -std::numeric_limits<double>::infinity();
    for (int cut = 0; cut < kCuts; ++cut) {
        Eigen::Vector3d uphill = Eigen::Vector3d::UnitZ();
        if (x.z() > bounds.high) {
            uphill = -uphill;
        } else if (x.z() >= bounds.low) {
            const Spare spare = worstSpare(faces, x, tau);
            uphill = spare.gradient;
            if (spare.value > most) {
                most = spare.value;
                best = x;
            }
        }
        const double scale = uphill.dot(shape * uphill);
        if (!(scale > 0))
            break;
        const Eigen::Vector3d step = shape * uphill / std::sqrt(scale);
        x += step / (n + 1);
        shape = n * n / (n * n - 1) * (shape - 2 / (n + 1) * step * step.transpose());
    }
    return best;
}

} // namespace moldwright

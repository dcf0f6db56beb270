// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/plane_snaps.h"

#include <Eigen/Geometry>

namespace moldwright {

namespace {

constexpr double leastSine = 1e-6;

} // namespace

PartingPlane squareTo(const Eigen::Vector3d& axis, const Eigen::Vector3d& through, const PartingPlane& like) {
    const Eigen::Vector3d normal = axis.dot(like.normal) < 0 ? (-axis).eval() : axis;
    return {normal, normal.dot(through)};
}

std::optional<PartingPlane> planeThrough(const std::array<Eigen::Vector3d, 3>& points,
                                         const PartingPlane& like) {
    const Eigen::Vector3d a = points[1] - points[0];
    const Eigen::Vector3d b = points[2] - points[0];
    const Eigen::Vector3d across = a.cross(b);
    // The longest two sides: the sine of the angle between a short one and a long one may be large by chance.
    const double longest = std::max({a.norm(), b.norm(), (b - a).norm()});
    if (across.norm() <= leastSine * longest * longest)
        return std::nullopt;
    return squareTo(across.normalized(), (points[0] + points[1] + points[2]) / 3, like);
}

std::optional<PartingPlane> planeOfFace(const IndexedMesh& mesh, int face, const PartingPlane& like) {
    return planeThrough({mesh.corner(face, 0), mesh.corner(face, 1), mesh.corner(face, 2)}, like);
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/placing.h"

#include "mesh/measures.h"

namespace moldwright {

double millimetres(Unit unit) {
    switch (unit) {
    case Unit::Millimetre:
        return 1;
    case Unit::Centimetre:
        return 10;
    case Unit::Metre:
        return 1000;
    case Unit::Inch:
        return 25.4;
    }
    return 1;
}

Placement moved(const Placement& placement, const Eigen::Isometry3d& motion) {
    Placement edited = placement;
    edited.motion = motion * placement.motion;
    return edited;
}

Eigen::Isometry3d layFlat(const IndexedMesh& part, const Eigen::Vector3d& normal) {
    const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
    Eigen::Isometry3d motion(Eigen::Quaterniond::FromTwoVectors(normal, down));
    const double lowest = (part.V * motion.linear().transpose()).col(2).minCoeff();
    motion.pretranslate(Eigen::Vector3d(0, 0, -lowest));
    return motion;
}

Eigen::Isometry3d turnAbout(const IndexedMesh& part, const Eigen::Vector3d& axis, double degrees) {
    const Eigen::Vector3d middle = boundingBox(part).center();
    Eigen::Isometry3d motion(Eigen::AngleAxisd(radians(degrees), axis));
    motion.translation() = middle - motion.linear() * middle;
    return motion;
}

Eigen::Isometry3d quarterTurn(const IndexedMesh& part, const Eigen::Vector3d& axis) {
    const Eigen::Vector3d middle = boundingBox(part).center();
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    for (int column = 0; column < 3; ++column) {
        const Eigen::Vector3d e = Eigen::Vector3d::Unit(column);
        motion.linear().col(column) = axis * axis.dot(e) + axis.cross(e);
    }
    motion.translation() = middle - motion.linear() * middle;
    return motion;
}

} // namespace moldwright

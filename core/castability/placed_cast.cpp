// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/placed_cast.h"

#include "base/stop_point.h"
#include "castability/certificate.h"
#include "castability/float_rounding.h"

#include <limits>

namespace moldwright {

namespace {

using Eigen::AlignedBox3d;
using Eigen::Isometry3d;
using Eigen::Vector3d;

Points movedPoints(const Points& V, const Isometry3d& motion) {
    return (V * motion.linear().transpose()).rowwise() + motion.translation().transpose();
}

AlignedBox3d boxOf(const Points& V) {
    return {V.colwise().minCoeff().transpose(), V.colwise().maxCoeff().transpose()};
}

/// The turn about z, in steps of a degree, that gives the points the box of least floor area. Among equals
/// the smallest turn, so that an upright part stays upright.
Isometry3d smallestFloor(const Points& V) {
    Isometry3d best = Isometry3d::Identity();
    double bestArea = std::numeric_limits<double>::infinity();
    for (int degree = 0; degree < 90; ++degree) {
        stopPoint();
        Isometry3d turn = Isometry3d::Identity();
        turn.linear() = Eigen::AngleAxisd(radians(degree), Vector3d::UnitZ()).toRotationMatrix();
        const Vector3d size = boxOf(movedPoints(V, turn)).sizes();
        const double area = size.x() * size.y();
        constexpr double clearlySmaller = 1 - 1e-6;
        if (area < clearlySmaller * bestArea) {
            bestArea = area;
            best = turn;
        }
    }
    return best;
}

Isometry3d motionToMold(const IndexedMesh& cast, const PartingPlane& plane) {
    Isometry3d motion = planeFrame(plane);
    motion = smallestFloor(movedPoints(cast.V, motion)) * motion;
    const Vector3d centre = boxOf(movedPoints(cast.V, motion)).center();
    return Eigen::Translation3d(-centre.x(), -centre.y(), 0) * motion;
}

/// Points that faces of both sides share, and points of faces that lie in the plane, are points of the plane.
void putOnPlane(IndexedMesh& mesh, const IndexedMesh& cast, const SideLabels& labels,
                const PartingPlane& plane) {
    std::vector<std::uint8_t> sides(static_cast<std::size_t>(cast.vertexCount()), 0);
    for (int f = 0; f < cast.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            sides[static_cast<std::size_t>(cast.F(f, k))] |= labels[static_cast<std::size_t>(f)];
    const double tolerance = onPlaneTolerance(cast);
    for (int v = 0; v < cast.vertexCount(); ++v)
        if (sides[static_cast<std::size_t>(v)] == 3 || std::abs(plane.distance(cast.point(v))) <= tolerance)
            mesh.V(v, 2) = 0;
}

} // namespace

PlacedCast placeCast(const IndexedMesh& cast, const SideLabels& labels, const MoldState& state,
                     double draftDegrees, double grid) {
    PlacedCast placed;
    placed.fromPart = motionToMold(cast, state.plane);
    placed.state.directions.d1 = (placed.fromPart.linear() * state.directions.d1).normalized();
    placed.state.directions.d2 = (placed.fromPart.linear() * state.directions.d2).normalized();
    IndexedMesh mesh{movedPoints(cast.V, placed.fromPart), cast.F};
    putOnPlane(mesh, cast, labels, state.plane);
    placed.mesh = roundKeepingDraft(mesh, labels, placed.state.directions, draftDegrees, grid);
    return placed;
}

} // namespace moldwright

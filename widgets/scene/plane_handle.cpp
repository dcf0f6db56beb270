// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/plane_handle.h"

#include <algorithm>
#include <cmath>

namespace moldwright::scene {

namespace {

constexpr double overhang = 0.12; ///< of the longer half side

double rounded(double value, double step, bool coarse) {
    return coarse ? std::round(value / step) * step : value;
}

/// How far along the normal the pointer went, mm, read off the normal's picture on the screen.
double alongNormal(const PlaneDrag& drag, const Camera& camera, ViewSize view, double toX, double toY) {
    const Eigen::Vector3d place = gripPlace(drag.rectangle, drag.grip);
    const double step = 10 * camera.pixelSize(view);
    const Eigen::Vector2d perStep =
        (camera.project(place + step * drag.start.plane.normal, view) - camera.project(place, view))
            .head<2>();
    const Eigen::Vector2d way(toX - drag.x, toY - drag.y);
    // Seen from straight above, the normal has no direction on the screen: up is then along it.
    if (perStep.norm() < 2)
        return -way.y() * camera.pixelSize(view);
    return way.dot(perStep) / perStep.squaredNorm() * step;
}

} // namespace

PlaneRectangle planeRectangle(const PartingPlane& plane, const Points& points) {
    PlaneRectangle rectangle;
    const Eigen::Vector3d& n = plane.normal;
    const Eigen::Vector3d seed =
        std::abs(n.z()) < 0.9 ? Eigen::Vector3d::UnitZ().eval() : Eigen::Vector3d::UnitY().eval();
    rectangle.u = seed.cross(n).normalized();
    rectangle.v = n.cross(rectangle.u);
    if (points.rows() == 0)
        return rectangle;
    const Eigen::VectorXd s = points * rectangle.u;
    const Eigen::VectorXd t = points * rectangle.v;
    rectangle.centre = plane.offset * n + (s.minCoeff() + s.maxCoeff()) / 2 * rectangle.u +
                       (t.minCoeff() + t.maxCoeff()) / 2 * rectangle.v;
    const double larger = overhang * std::max(s.maxCoeff() - s.minCoeff(), t.maxCoeff() - t.minCoeff()) / 2;
    rectangle.halfU = (s.maxCoeff() - s.minCoeff()) / 2 + larger;
    rectangle.halfV = (t.maxCoeff() - t.minCoeff()) / 2 + larger;
    return rectangle;
}

Eigen::Vector3d gripPlace(const PlaneRectangle& rectangle, Grip grip) {
    switch (grip) {
    case Grip::SlidePlane:
        return rectangle.at(1, 1);
    case Grip::TiltAboutV:
        return rectangle.at(1, 0);
    case Grip::TiltAboutU:
        return rectangle.at(0, 1);
    default:
        return rectangle.centre;
    }
}

MoldState PlaneDrag::moved(const Camera& camera, ViewSize view, double toX, double toY, bool coarse) const {
    const double way = alongNormal(*this, camera, view, toX, toY);
    PartingPlane plane = start.plane;
    if (grip == Grip::SlidePlane) {
        plane.offset = rounded(plane.offset + way, 1, coarse);
        return withPlane(start, plane);
    }
    const bool aboutV = grip == Grip::TiltAboutV;
    const double arm = aboutV ? rectangle.halfU : rectangle.halfV;
    const double angle = rounded(std::atan2(way, arm), radians(5), coarse);
    // A grip that rises along n turns n backwards, towards the middle.
    const Eigen::Vector3d axis = aboutV ? (-rectangle.v).eval() : rectangle.u;
    plane.normal = (Eigen::AngleAxisd(angle, axis) * plane.normal).normalized();
    plane.offset = plane.normal.dot(rectangle.centre);
    return withPlane(start, plane);
}

MoldState withPlane(const MoldState& state, const PartingPlane& plane) {
    if (plane.normal == state.plane.normal)
        return {plane, state.directions};
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(state.plane.normal, plane.normal);
    return {plane, {(turn * state.directions.d1).normalized(), (turn * state.directions.d2).normalized()}};
}

} // namespace moldwright::scene

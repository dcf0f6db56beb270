// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace moldwright::scene {

namespace {

constexpr double margin = 1.12;

Eigen::Vector3d viewPoint(const Camera& camera, double x, double y, ViewSize view) {
    const double right = (2 * x / view.width - 1) * camera.halfHeight() * view.width / view.height;
    const double up = (1 - 2 * y / view.height) * camera.halfHeight();
    return camera.focus + right * camera.right() + up * camera.up();
}

} // namespace

double Camera::halfHeight() const {
    return distance * std::tan(viewAngle * std::numbers::pi / 360);
}

Ray Camera::rayAt(double x, double y, ViewSize view) const {
    const Eigen::Vector3d target = viewPoint(*this, x, y, view);
    if (perspective)
        return {position(), (target - position()).normalized()};
    // Parts in front of the focus plane must be hit too, however near the camera is.
    return {target + 100 * distance * backwards(), -backwards()};
}

Eigen::Vector3d Camera::project(const Eigen::Vector3d& point, ViewSize view) const {
    const Eigen::Vector3d offset = turn.conjugate() * (point - focus);
    const double depth = distance - offset.z();
    const double scale = halfHeight() * (perspective ? std::max(depth, 1e-9 * distance) / distance : 1);
    return {view.width / 2 + offset.x() / scale * view.height / 2,
            view.height / 2 - offset.y() / scale * view.height / 2, depth};
}

Camera orbited(const Camera& camera, const Eigen::Vector3d& pivot, double yaw, double pitch) {
    const Eigen::Quaterniond about =
        Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, camera.right());
    Camera turned = camera;
    turned.turn = (about * camera.turn).normalized();
    turned.focus = pivot + about * (camera.focus - pivot);
    return turned;
}

Camera panned(const Camera& camera, double dx, double dy, ViewSize view) {
    Camera moved = camera;
    moved.focus += camera.pixelSize(view) * (-dx * camera.right() + dy * camera.up());
    return moved;
}

Camera zoomedAt(const Camera& camera, double factor, double x, double y, ViewSize view) {
    Camera nearer = camera;
    nearer.distance = camera.distance / factor;
    nearer.focus += viewPoint(camera, x, y, view) - viewPoint(nearer, x, y, view);
    return nearer;
}

std::vector<Eigen::Vector3d> cornersOf(const Eigen::AlignedBox3d& box) {
    std::vector<Eigen::Vector3d> corners;
    for (int corner = 0; corner < 8 && !box.isEmpty(); ++corner)
        corners.push_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
    return corners;
}

Camera fitted(const Camera& camera, const Eigen::AlignedBox3d& box, ViewSize view) {
    return fitted(camera, cornersOf(box), view);
}

Camera fitted(const Camera& camera, std::span<const Eigen::Vector3d> points, ViewSize view) {
    Eigen::AlignedBox3d seen;
    for (const Eigen::Vector3d& point : points)
        seen.extend(camera.turn.conjugate() * point);
    if (seen.isEmpty())
        return camera;
    const Eigen::Vector3d half = seen.sizes() / 2;
    const double needed = std::max(half.y(), half.x() * view.height / view.width) * margin;
    Camera fit = camera;
    fit.focus = camera.turn * seen.center();
    fit.distance = std::max(needed, 1e-6) / std::tan(camera.viewAngle * std::numbers::pi / 360);
    if (camera.perspective)
        fit.distance += half.z();
    return fit;
}

Camera lookingFrom(const Camera& camera, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d back = direction.normalized();
    const bool vertical = std::abs(back.z()) > 0.999;
    const Eigen::Vector3d hint =
        vertical ? Eigen::Vector3d(0, back.z() > 0 ? 1 : -1, 0) : Eigen::Vector3d(0, 0, 1);
    Eigen::Matrix3d axes;
    axes.col(2) = back;
    axes.col(0) = hint.cross(back).normalized();
    axes.col(1) = back.cross(axes.col(0));
    Camera turned = camera;
    turned.turn = Eigen::Quaterniond(axes);
    return turned;
}

Camera between(const Camera& from, const Camera& to, double t) {
    Camera mixed = to;
    mixed.turn = from.turn.slerp(t, to.turn);
    mixed.focus = from.focus + t * (to.focus - from.focus);
    mixed.distance = from.distance * std::pow(to.distance / from.distance, t);
    return mixed;
}

} // namespace moldwright::scene

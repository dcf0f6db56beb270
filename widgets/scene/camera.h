// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace moldwright::scene {

/// Size of a view in device pixels.
struct ViewSize {
    double width = 1;
    double height = 1;
};

/// A straight line into the scene, mm; `direction` is unit.
struct Ray {
    Eigen::Vector3d origin;
    Eigen::Vector3d direction;
};

/// Where the scene is seen from. A value: moving it makes a new one. Lengths in mm. Pixels count from the
/// upper left corner of the view, y downwards.
struct Camera {
    Eigen::Vector3d focus = Eigen::Vector3d::Zero();
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity(); ///< camera axes (right, up, backwards) to world
    double distance = 100;
    double viewAngle = 26; ///< degrees, vertical
    bool perspective = false;

    [[nodiscard]] Eigen::Vector3d right() const { return turn * Eigen::Vector3d::UnitX(); }
    [[nodiscard]] Eigen::Vector3d up() const { return turn * Eigen::Vector3d::UnitY(); }
    [[nodiscard]] Eigen::Vector3d backwards() const { return turn * Eigen::Vector3d::UnitZ(); }
    [[nodiscard]] Eigen::Vector3d position() const { return focus + distance * backwards(); }

    /// Half of the height seen at the focus, mm: VTK's parallel scale. One number for both projections, so
    /// that switching perspective keeps the size.
    [[nodiscard]] double halfHeight() const;

    /// mm a pixel covers at the depth of the focus.
    [[nodiscard]] double pixelSize(ViewSize view) const { return 2 * halfHeight() / view.height; }

    /// The ray under a pixel.
    [[nodiscard]] Ray rayAt(double x, double y, ViewSize view) const;

    /// Pixel of a point; z is its depth along the view from the camera, mm.
    [[nodiscard]] Eigen::Vector3d project(const Eigen::Vector3d& point, ViewSize view) const;
};

/// Turned about `pivot`, which keeps its place on the screen: `yaw` about the world's z, `pitch` about the
/// camera's right, radians.
[[nodiscard]] Camera orbited(const Camera& camera, const Eigen::Vector3d& pivot, double yaw, double pitch);

/// Moved so that what is at the focus's depth follows the pointer by (dx, dy) pixels.
[[nodiscard]] Camera panned(const Camera& camera, double dx, double dy, ViewSize view);

/// Nearer by `factor` (> 1 is nearer); what is under the pixel (x, y) stays under it.
[[nodiscard]] Camera zoomedAt(const Camera& camera, double factor, double x, double y, ViewSize view);

/// Looking the same way, all points in sight with a margin; as it was when there are none.
[[nodiscard]] Camera fitted(const Camera& camera, std::span<const Eigen::Vector3d> points, ViewSize view);

/// The same for the corners of a box.
[[nodiscard]] Camera fitted(const Camera& camera, const Eigen::AlignedBox3d& box, ViewSize view);

/// The eight corners of a box, or none of an empty one.
[[nodiscard]] std::vector<Eigen::Vector3d> cornersOf(const Eigen::AlignedBox3d& box);

/// Looking from `direction` (need not be unit) towards the focus, z up, or y up when looking along z.
[[nodiscard]] Camera lookingFrom(const Camera& camera, const Eigen::Vector3d& direction);

/// Part of the way from one camera to another, t in [0, 1].
[[nodiscard]] Camera between(const Camera& from, const Camera& to, double t);

} // namespace moldwright::scene

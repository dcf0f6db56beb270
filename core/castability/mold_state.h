// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace moldwright {

/// The parting plane n·x = o (the paper's cut plane p). Side 1 is n·x > o.
struct PartingPlane {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< unit n
    double offset = 0;                                 ///< o, mm

    /// Signed distance of x from the plane, mm; positive on side 1.
    [[nodiscard]] double distance(const Eigen::Vector3d& x) const { return normal.dot(x) - offset; }

    bool operator==(const PartingPlane&) const = default;
};

/// The removal directions, unit. Always d1·n > 0 and d2·n < 0.
struct Directions {
    Eigen::Vector3d d1 = Eigen::Vector3d::UnitZ();
    Eigen::Vector3d d2 = -Eigen::Vector3d::UnitZ();

    [[nodiscard]] const Eigen::Vector3d& of(int side) const { return side == 1 ? d1 : d2; }

    /// d1 = n, d2 = −n.
    [[nodiscard]] static Directions normalTo(const PartingPlane& plane) {
        return {plane.normal, -plane.normal};
    }

    bool operator==(const Directions&) const = default;
};

/// Plane and directions together: all of the state but the mesh. [Stein 2019], Section 3.
struct MoldState {
    PartingPlane plane;
    Directions directions;

    bool operator==(const MoldState&) const = default;
};

/// The side (1 or 2) that each face belongs to.
using SideLabels = std::vector<std::uint8_t>;

[[nodiscard]] inline double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}
[[nodiscard]] inline double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

/// Angle of face normal N (unit) against direction d (unit): asin(N·d), degrees. Castable when ≥ the draft
/// angle.
[[nodiscard]] inline double draftDegrees(double NdotD) {
    return degrees(std::asin(std::clamp(NdotD, -1.0, 1.0)));
}

/// Two unit vectors x, y in a plane of unit normal n so that (x, y, n) is a right-handed frame; the same for
/// the same n.
[[nodiscard]] std::array<Eigen::Vector3d, 2> planeAxes(const Eigen::Vector3d& n);

/// Rigid motion that takes the plane to z = 0, side 1 up; its axes are planeAxes().
[[nodiscard]] Eigen::Isometry3d planeFrame(const PartingPlane& plane);

} // namespace moldwright

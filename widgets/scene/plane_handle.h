// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"
#include "scene/camera.h"
#include "scene/grips.h"

#include <Eigen/Geometry>

#include <array>

namespace moldwright::scene {

/// The rectangle that stands for the parting plane in the view: centre, two unit axes in the plane, half
/// sizes in mm.
struct PlaneRectangle {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d u = Eigen::Vector3d::UnitX();
    Eigen::Vector3d v = Eigen::Vector3d::UnitY();
    double halfU = 1;
    double halfV = 1;

    [[nodiscard]] Eigen::Vector3d at(double s, double t) const {
        return centre + s * halfU * u + t * halfV * v;
    }
};

/// The rectangle in `plane` that the shadow of these points along the normal fills, a little larger.
[[nodiscard]] PlaneRectangle planeRectangle(const PartingPlane& plane, const Points& points);

inline constexpr std::array planeGrips = {Grip::SlidePlane, Grip::TiltAboutV, Grip::TiltAboutU};

/// Where a grip of the plane sits, mm.
[[nodiscard]] Eigen::Vector3d gripPlace(const PlaneRectangle& rectangle, Grip grip);

/// A drag of a grip of the plane, from the state it started in. `coarse` rounds to whole millimetres and 5°.
struct PlaneDrag {
    MoldState start;
    PlaneRectangle rectangle;
    Grip grip = Grip::SlidePlane;
    double x = 0; ///< pixel where the drag began
    double y = 0;

    /// The state with the pointer at (x, y): directions turn with the plane.
    [[nodiscard]] MoldState moved(const Camera& camera, ViewSize view, double toX, double toY,
                                  bool coarse) const;
};

/// `state` with another normal and offset; directions keep their angles to the plane.
[[nodiscard]] MoldState withPlane(const MoldState& state, const PartingPlane& plane);

} // namespace moldwright::scene

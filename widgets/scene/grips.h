// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/camera.h"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace moldwright::scene {

/// What can be taken hold of in the view: the plane's corner slides it along its normal, its edges tilt it;
/// the tip of an arrow turns its removal direction.
enum class Grip { SlidePlane, TiltAboutV, TiltAboutU, Direction1, Direction2 };

/// Where a grip sits, mm.
struct GripPlace {
    Grip grip = Grip::SlidePlane;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
};

/// The grip within `reach` pixels of the pointer.
[[nodiscard]] std::optional<Grip> gripAt(std::span<const GripPlace> grips, const Camera& camera,
                                         ViewSize view, double x, double y, double reach);

} // namespace moldwright::scene

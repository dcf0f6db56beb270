// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/grips.h"

#include <cmath>

namespace moldwright::scene {

std::optional<Grip> gripAt(std::span<const GripPlace> grips, const Camera& camera, ViewSize view, double x,
                           double y, double reach) {
    std::optional<Grip> nearest;
    for (const GripPlace& grip : grips) {
        const Eigen::Vector3d pixel = camera.project(grip.place, view);
        const double away = std::hypot(pixel.x() - x, pixel.y() - y);
        if (away <= reach) {
            reach = away;
            nearest = grip.grip;
        }
    }
    return nearest;
}

} // namespace moldwright::scene

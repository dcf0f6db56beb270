// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

/// A pin in a shape that it was drawn into the parting plane in.
struct PlacedPin {
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< in the shape's frame, in the plane
    int surfacePoint = -1; ///< the point of the shape's surface that is pinned; −1: one inside
};

/// The places of the pins inside, a row each.
[[nodiscard]] inline Points innerPlaces(const std::vector<PlacedPin>& pins) {
    Points places(static_cast<Eigen::Index>(pins.size()), 3);
    Eigen::Index count = 0;
    for (const PlacedPin& pin : pins)
        if (pin.surfacePoint < 0)
            places.row(count++) = pin.place.transpose();
    places.conservativeResize(count, Eigen::NoChange);
    return places;
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "field.h"

#include <vector>

namespace moldwright::samples {

/// One place along a limb: half its width and half its thickness there, mm.
struct Station {
    Station(const Vector3d& place, double radius) : Station(place, radius, radius) {}
    Station(const Vector3d& place, double halfWidth, double halfThickness)
        : at(place), width(halfWidth), thickness(halfThickness) {}

    Vector3d at;
    double width;
    double thickness;
};

/// A bent, tapered limb: a Catmull–Rom spline through the stations with an elliptic cross-section whose
/// thickness is measured along `flat` (made perpendicular to the spline). Its ends are rounded. At least two
/// stations.
[[nodiscard]] Field limb(const std::vector<Station>& stations, const Vector3d& flat = Vector3d::UnitX());

} // namespace moldwright::samples

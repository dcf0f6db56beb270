// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/placing_snap.h"

#include <cmath>

namespace moldwright {

namespace {

constexpr double step = 0.5; // mm

bool ofCavity(Placeable kind) {
    return kind == Placeable::Vent || kind == Placeable::Ejector || kind == Placeable::Overflow;
}

} // namespace

Eigen::Vector2d snapped(const Eigen::Vector2d& wish, const PlacedRow& dragged,
                        const std::vector<PlacedRow>& rows, double reach) {
    Eigen::Vector2d place;
    for (int axis = 0; axis < 2; ++axis) {
        double best = std::round(wish[axis] / step) * step;
        double nearest = reach;
        const auto offer = [&](double value) {
            if (const double away = std::abs(value - wish[axis]); away < nearest) {
                nearest = away;
                best = value;
            }
        };
        offer(0);
        for (const PlacedRow& other : rows) {
            const bool itself =
                other.stands.kind == dragged.stands.kind && other.stands.number == dragged.stands.number;
            if (itself || ofCavity(other.stands.kind) != ofCavity(dragged.stands.kind))
                continue;
            offer(other.stands.place[axis]);
            offer(-other.stands.place[axis]);
        }
        place[axis] = best;
    }
    return place;
}

} // namespace moldwright

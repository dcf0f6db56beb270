// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/layout.h"

#include <vector>

namespace moldwright {

/// One kind of cavity for each place on a circle, counter-clockwise from the upper left, of the part that
/// stands there: its +y points to the middle, from where it is filled. Where the removal directions do not
/// allow one of the turns, all are their parts as they are, only moved; what then points to the middle is
/// another side of each.
[[nodiscard]] std::vector<CavityKind> kindsRound(const std::vector<CavityKind>& parts,
                                                 const std::vector<std::size_t>& partAt,
                                                 const CavityRules& rules);

/// What fills cavities on a circle from its middle, mm; zero without.
struct StarRoom {
    double spout = 0; ///< width of what leads straight up from the middle
    double arm = 0;   ///< width of a channel to a cavity
    double hub = 0;   ///< from the middle to where an arm stands clear of the others
};

/// The kinds on the smallest circle on which they keep `spacing` from each other and from all channels.
/// `tips`: of each the place that is filled, mm, its own coordinates: all are at the same distance from the
/// middle.
[[nodiscard]] Layout circleLayout(const std::vector<CavityKind>& kinds,
                                  const std::vector<Eigen::Vector2d>& tips, double spacing,
                                  const StarRoom& room);

/// A strip from the middle of a star along a direction.
[[nodiscard]] PlanShape starArm(const Eigen::Vector2d& hub, const Eigen::Vector2d& way, double length,
                                double width);

} // namespace moldwright

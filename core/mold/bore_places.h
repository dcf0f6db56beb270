// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "mold/layout.h"

namespace moldwright {

/// A place at which a hole along the removal direction can enter a cavity.
struct BorePlace {
    Eigen::Vector2d axis = Eigen::Vector2d::Zero(); ///< where its axis meets the parting plane, mm
    double tip = 0;                                 ///< height of the cavity over the plane there, mm
    double inside = 0;                              ///< a height at which its whole circle lies in the cast
};

/// Places for the pins of one kind of cavity: where the cast reaches deep into the half and is flat enough
/// under the whole pin (at most 35° from square to it), deepest first, then far from each other. Pins keep
/// `steel` mm from the parting line, from each other, and from `keepOff` (points of the plane, each with a
/// radius). Errors: Impossible, with how many found a place and why not more.
[[nodiscard]] Result<std::vector<BorePlace>>
ejectorPlaces(const CavityKind& kind, const Directions& directions, const EjectorSettings& ejectors,
              double steel, const std::vector<std::pair<Eigen::Vector2d, double>>& keepOff);

/// For each solid of the cavity the highest place of half 1 with room for a spout's neck `width` mm wide.
/// Errors: Impossible.
[[nodiscard]] Result<std::vector<BorePlace>> spoutPlaces(const CavityKind& kind, const Directions& directions,
                                                         double width);

} // namespace moldwright

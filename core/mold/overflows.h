// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "mold/cavity_joints.h"
#include "mold/free_place.h"
#include "mold/layout.h"

#include <vector>

namespace moldwright {

/// How far a cavity's wells reach beyond its outline at most, mm; 0 without.
[[nodiscard]] double overflowReach(const OverflowSettings& settings);

/// The steel that a layout keeps between cavities so that their wells have room as well, mm.
[[nodiscard]] double spacingWithOverflows(const MoldSettings& settings);

/// What the places of one kind's wells follow from besides.
struct OverflowPlan {
    const MoldSettings* settings = nullptr;
    int firstNumber = 0;           ///< of the kind's wells
    std::vector<PlanShape> others; ///< what wells keep the least steel from, the kind's coordinates
};

/// How many wells a kind has: so many for each of its solids.
[[nodiscard]] int overflowCount(const CavityKind& kind, const OverflowSettings& settings);

/// The wells of one kind of cavity, solid by solid: by hand, or where an air trap without a vent meets the
/// parting line, or at the place of the line that is farthest from gates and other wells, where material
/// arrives last. Errors: Impossible, with the place, where there is no room or a channel cannot leave where a
/// hand put it.
[[nodiscard]] Result<std::vector<Overflow>>
overflowsOf(const CavityKind& kind, const CavityFeatures& features, const OverflowPlan& plan);

/// Channel and well seen along the normal.
[[nodiscard]] PlanShape overflowChannel(const Overflow& overflow, const OverflowSettings& settings);
[[nodiscard]] PlanShape overflowWell(const Overflow& overflow, const OverflowSettings& settings);

/// Both as bodies with walls that leave along the mold's directions; the channel opens into the well.
/// `attempt`: it is moved by so many hundredths of its width. Errors: Impossible, where the walls' lean
/// leaves the well no floor.
[[nodiscard]] Result<JoinedOverflow> overflowBodies(const Overflow& overflow,
                                                    const OverflowSettings& settings,
                                                    const ChannelRules& rules, int attempt);

} // namespace moldwright

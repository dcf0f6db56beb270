// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "castability/placed_cast.h"
#include "mold/layout.h"

#include <Eigen/Geometry>

#include <string>

namespace moldwright {

/// A part as it stands in a mold.
struct StandingPart {
    CavityKind upright;
    Eigen::Isometry3d fromPart = Eigen::Isometry3d::Identity(); ///< part's frame to mold's frame
};

/// A part that was placed by its own plane and directions, in the mold that is made for another one: turned
/// about the normal by `quarters` where it leaves along the mold's directions then; else as its own
/// directions agree best with those, or its faces have most draft. Errors: BadInput where it is no finished
/// cast; Impossible where no turn allows it, with the draft that it would have. `name`: for these.
[[nodiscard]] Result<StandingPart> furtherPart(const PlacedCast& placed, const SideLabels& labels,
                                               int quarters, const CavityRules& rules,
                                               const std::string& name);

} // namespace moldwright

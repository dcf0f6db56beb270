// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "mold/layout.h"

#include <vector>

namespace moldwright {

/// One kind of cavity for each place of a free layout, of the part that stands there, turned as asked for.
/// Errors: Usage without a place; Impossible where the removal directions do not allow a turn, with the draft
/// that the cavity would have.
[[nodiscard]] Result<std::vector<CavityKind>> kindsAtPlaces(const std::vector<CavityKind>& parts,
                                                            const std::vector<std::size_t>& partAt,
                                                            const CavityRules& rules,
                                                            const std::vector<CavityPlace>& places);

/// The kinds at their places, as a whole about the origin. `spoutWidth`: mm, of a spout that leads straight
/// up from each of `tips` (the kind's coordinates); 0 without. Errors: Impossible where two cavities are
/// nearer than `steel`, or a spout passes another cavity or spout nearer than that.
[[nodiscard]] Result<Layout> freeLayout(const std::vector<CavityKind>& kinds,
                                        const std::vector<CavityPlace>& places,
                                        const std::vector<std::vector<Eigen::Vector2d>>& tips,
                                        double spoutWidth, double steel);

} // namespace moldwright

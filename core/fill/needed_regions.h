// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "fill/choice_mesh.h"

#include <vector>

namespace moldwright {

/// Which regions the topological certificate asks for, a mark per region: the largest that can be left are
/// left, first as they hang together, then divided at their necks. Regions are numbered anew, the largest
/// first. `size` of the part, mm; regions of no more volume than `nothing` (mm³) are left out of the choice.
[[nodiscard]] std::vector<char> neededRegions(ChoiceMesh& choices, const Directions& directions, double size,
                                              double nothing, const Task& task);

/// Where a surface that was to stay is crossed by one that filling makes, by the hair that tidying takes, its
/// region is filled as well. Returns whether nothing crosses in the end.
[[nodiscard]] bool dragAlong(const ChoiceMesh& choices, std::vector<char>& filled, const Task& task = {});

} // namespace moldwright

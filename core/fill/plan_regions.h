// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fill/fill_plan.h"

#include <vector>

namespace moldwright {

/// Faces of the plan's part that vanish when a region is filled, ascending.
[[nodiscard]] std::vector<int> facesCovered(const FillPlan& plan, int region);

/// The faces that filling a region makes, over the points of the plan's choices.
[[nodiscard]] Triangles facesMade(const FillPlan& plan, int region);

/// The region whose covered faces come nearest to a place (plane's frame); −1 where there are no regions.
[[nodiscard]] int regionNearest(const FillPlan& plan, const Eigen::Vector3d& place);

/// Per region: whether filling it joins pieces of the part that are apart.
[[nodiscard]] std::vector<char> regionsThatJoin(const FillPlan& plan);

/// The needed regions that cover any of these faces of the part, ascending.
[[nodiscard]] std::vector<int> neededRegionsAt(const FillPlan& plan, const std::vector<int>& faces);

} // namespace moldwright

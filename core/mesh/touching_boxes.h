// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <functional>
#include <utility>
#include <vector>

namespace moldwright {

/// Pairs (f < g) of the given faces whose axis-aligned boxes touch and for which keep(f, g) holds, in
/// ascending order. A tree of boxes over the faces along a space-filling curve; near-linear unless many boxes
/// overlap. `keep` is called from several threads at once.
[[nodiscard]] std::vector<std::pair<int, int>>
pairsWithTouchingBoxes(const IndexedMesh& mesh, const std::vector<int>& faces,
                       const std::function<bool(int, int)>& keep);

} // namespace moldwright

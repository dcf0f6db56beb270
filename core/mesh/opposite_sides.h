// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

/// Side 3f+k of a face runs from its corner k to the next. For each side the one that runs back along it; −1
/// where none does. `crowded`: some edge has more than two sides, or two that run the same way.
struct OppositeSides {
    std::vector<int> of;
    bool crowded = false;
};

/// In linear time. Points are numbered 0 … points−1.
[[nodiscard]] OppositeSides oppositeSides(const Triangles& F, int points);

/// Whether the faces form closed surfaces: every side has one opposite, every point one fan of faces.
[[nodiscard]] bool closedManifold(const Triangles& F, int points);

} // namespace moldwright

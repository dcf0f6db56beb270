// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

namespace moldwright {

/// Volume of the wall that stays when a solid is cast hollow, mm³: what lies within `wall` mm of its surface.
/// Measured at the points of a grid, sixty across its longest side or three through the wall, but no finer
/// than two hundred across while one is through the wall; a place at the wall's inner face counts as far as
/// it lies in. What is far from that face is passed over in strides: O(grid of its area · log m).
[[nodiscard]] double shellVolume(const IndexedMesh& solid, double wall);

} // namespace moldwright

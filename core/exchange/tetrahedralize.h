// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "base/task.h"
#include "mesh/tet_mesh.h"

#include <string>
#include <vector>

namespace moldwright {

/// TetGen's switches for a part that bends itself: the surface is kept, tetrahedra are well shaped.
inline constexpr const char* kTetGenSwitches = "pYq1.414";

/// Fills a closed surface with tetrahedra by TetGen ([Si 2018]), run in the worker program under limits of
/// memory and time. `switches` are TetGen's; pYq1.414 keeps the surface as it is. The answer is checked:
/// there are tetrahedra, all positive after orientation, their volumes sum to the surface's within 1e-6, the
/// surface points come first and unmoved, every surface face is a face of exactly one tetrahedron. Points
/// `inside` (n×3, strictly inside) become points of tetrahedra too, somewhere behind those of the surface: by
/// TetGen, or where it fails at them by insertPoint().
/// Precondition: closed, outward, free of self-intersection, size about 1. Errors: Worker, Cancelled.
[[nodiscard]] Result<TetMesh> tetrahedralize(const IndexedMesh& surface, const Task& task = {},
                                             const std::string& switches = kTetGenSwitches,
                                             const Points& inside = Points(0, 3));

/// The index of each of the points `inside` among the tetrahedra's; −1 where it is not there.
[[nodiscard]] std::vector<int> innerPoints(const TetMesh& tets, int surfacePoints, const Points& inside);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "base/task.h"
#include "mesh/tet_mesh.h"

#include <string>

namespace moldwright {

/// Fills a closed surface with tetrahedra by TetGen ([Si 2018]), run in the worker program under limits of
/// memory and time. `switches` are TetGen's; pYq1.414 keeps the surface as it is. The answer is checked:
/// there are tetrahedra, all positive after orientation, their volumes sum to the surface's within 1e-6, the
/// surface points come first and unmoved, every surface face is a face of exactly one tetrahedron.
/// Precondition: closed, outward, free of self-intersection, size about 1. Errors: Worker, Cancelled.
[[nodiscard]] Result<TetMesh> tetrahedralize(const IndexedMesh& surface, const Task& task = {},
                                             const std::string& switches = "pYq1.414");

} // namespace moldwright

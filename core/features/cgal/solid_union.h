// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <optional>

namespace moldwright {

/// The union of two closed solids that really cross, by exact corefinement (CGAL). New points are rounded to
/// doubles, which the caller must check once more. None when either is not closed and outward, or the result
/// is not manifold. Deterministic.
[[nodiscard]] std::optional<IndexedMesh> unionOfSolids(const IndexedMesh& a, const IndexedMesh& b);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

namespace moldwright {

/// A closed surface without crossings about all faces of a mesh, at `offset` mm from them, by CGAL's alpha
/// wrapping ([Alliez 2022]): what a ball of diameter `alpha` mm cannot roll into is bridged. Outward.
/// Precondition: both > 0. CGAL may throw: only the worker program calls it.
[[nodiscard]] IndexedMesh wrapSurface(const IndexedMesh& mesh, double alpha, double offset);

} // namespace moldwright

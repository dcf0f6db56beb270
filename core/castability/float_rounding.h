// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

namespace moldwright {

/// `mesh` with every coordinate rounded to a float so that faces keep their draft: to the nearest float at
/// first; then, for a face that fell below the angle (a sliver turned by rounding), one of its points to
/// another of the floats next to it, if all faces round that point pass there. Coordinates that are floats
/// already stay. With a `grid`, a power of two, to its multiples instead of floats: then copies moved by
/// multiples are the same to the bit. What is still below the angle afterwards is for the certificate to say.
[[nodiscard]] IndexedMesh roundKeepingDraft(const IndexedMesh& mesh, const SideLabels& labels,
                                            const Directions& directions, double draftDegrees,
                                            double grid = 0);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

namespace moldwright {

/// A surface after mending, and what that took.
struct MendedSurface {
    IndexedMesh mesh;
    int facesRemoved = 0; ///< repeated ones, those without area, and loose scraps
    int holesFilled = 0;
    int facesFilled = 0;    ///< that filling holes made
    int crossings = 0;      ///< pairs of faces that crossed, and whose surroundings were made anew
    double largestHole = 0; ///< diagonal of its rim's box, mm
};

/// Mends a surface by CGAL: makes it manifold (edges and points that more faces share than may are split),
/// drops loose scraps (open pieces of one face, or of less than a thousandth of its area), closes gaps
/// between edges that fit, fills holes (flat ones by a flat cap, others smoothly), and makes faces anew where
/// it crosses itself. No promise: what it returns is to be examined. CGAL may throw, and may take long: only
/// the worker program calls it.
[[nodiscard]] MendedSurface mendSurface(const IndexedMesh& mesh);

} // namespace moldwright

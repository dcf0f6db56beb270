// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "contour.h"

namespace moldwright::samples {

/// How fine and how even a mesh shall be, mm.
struct Fineness {
    double shortest;  ///< edge length where the surface is most curved
    double longest;   ///< edge length where it is flat
    double deviation; ///< how far the middle of a face may lie off the surface
};

/// `mesh` (a closed surface near that of `solid`, see contour()) made even: edges split, collapsed and
/// flipped towards a length that follows the curvature [Dunyach et al. 2013], points spread within the
/// surface and drawn onto it. Points of a flat back stay at z = 0 exactly, and its rim stays sharp.
[[nodiscard]] IndexedMesh remesh(const IndexedMesh& mesh, const Solid& solid, const Fineness& fineness);

} // namespace moldwright::samples

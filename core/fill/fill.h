// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "base/task.h"
#include "castability/parting_line.h"

#include <vector>

namespace moldwright {

/// A part in which nothing is undercut any more.
struct FilledPart {
    PartedMesh surface;            ///< plane's frame; sourceFace −1: a wall or flat face that filling made
    std::vector<int> sourceVertex; ///< per point: the point of the parted mesh it is, −1 for a new one
    double volume = 0;             ///< what was filled in, mm³ (mesh unit cubed)
};

/// Fills both halves of a parted mesh: everything between a half's outermost surface along its direction and
/// the plane becomes solid. Closed, manifold, outward, free of self-intersection (checked); on every face of
/// label i N·d_i ≥ 0, on the walls that filling makes N·d_i = 0, up to rounding: they have no draft yet.
/// Points move by no more than 1e-7 of the size, to an exact grid. Near-linear; the same for any number of
/// threads. `part` and directions in the plane's frame. Source of the idea: [Stein 2019], Section 7,
/// "filling". Errors: Cancelled; Internal where the result does not pass its checks.
[[nodiscard]] Result<FilledPart> fill(const PartedMesh& part, const Directions& directions,
                                      const Task& task = {});

} // namespace moldwright

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
/// the plane becomes solid. The result is closed, manifold, outward, free of self-intersection, and passes
/// the topological certificate (all checked); on every face of label i N·d_i ≥ 0, on the walls that filling
/// makes N·d_i = 0, up to rounding: they have no draft yet. Points of the part that are kept lie on an exact
/// grid, no further than 1e-7 of the size from where they were; walls stand within a hundredth of the part's
/// mean edge of where the surface turns away. Near-linear; the same for any number of threads. `part` and
/// directions in the plane's frame. See ARCHITECTURE.md, "Fill". Errors: Cancelled; Internal where no attempt
/// passes the checks.
[[nodiscard]] Result<FilledPart> fill(const PartedMesh& part, const Directions& directions,
                                      const Task& task = {});

} // namespace moldwright

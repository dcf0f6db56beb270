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
    double volume = 0;             ///< what was filled in, mm³ (mesh unit cubed), without the skirts
    double skirtVolume = 0;        ///< what the skirts of fillWithDraft() added besides
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

/// The same with walls that lean: where filling, or the part itself, would miss the draft, a skirt falls from
/// the upper rim outwards, a little flatter than the draft asks for, and joins the surface or the plane
/// below. All faces have the draft, with something to spare for rounding, but for a few, in hundreds of faces
/// one at most, where skirts meet awkwardly: those a clean-up mends. The rest of the part stays where it is.
/// Everything else is as for fill(). Errors: those of fill().
[[nodiscard]] Result<FilledPart> fillWithDraft(const PartedMesh& part, const Directions& directions,
                                               double draftDegrees, const Task& task = {});

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "castability/parting_line.h"
#include "castability/plane_search.h"
#include "design/design.h"
#include "design/placed_pin.h"
#include "design/working_frame.h"
#include "mesh/tet_mesh.h"

#include <vector>

namespace moldwright {

/// The part parted by a plane, filled where that was asked for.
struct PartedPart {
    MoldState state; ///< part frame
    WorkingFrame frame;
    PartedMesh surface;            ///< working frame
    double filledVolume = 0;       ///< mm³ that filling added
    std::vector<PlacedPin> pins{}; ///< working frame, z = 0 exactly; surfacePoint: of `surface`
    IndexedMesh before{}; ///< part frame: the surface as it was before pins; what change is measured from
};

/// The same with tetrahedra inside: what the elastic deformation starts from.
struct PartedSolid : PartedPart {
    TetMesh tets; ///< working frame; surface points first
};

/// Parts the part at `state`, snapping less and less until the parted surface is free of self-intersection.
/// `pins` (part frame) lie in the plane; those on the surface become points of the parting line. Errors:
/// Impossible (the reasons in words, see findObstructions()), Internal, Cancelled.
[[nodiscard]] Result<PartedPart> partSurface(const IndexedMesh& part, const MoldState& state,
                                             const Task& task, const std::vector<PlacedPin>& pins = {});

/// The same, until TetGen takes it as well. Errors: also Worker.
[[nodiscard]] Result<PartedSolid> partSolid(const IndexedMesh& part, const MoldState& state, const Task& task,
                                            const std::vector<PlacedPin>& pins = {});

/// How much is filled: what the topological certificate asks for, the rest being left to bending, or all that
/// cannot leave.
enum class FillExtent { Needed, All };

/// The same for the part filled at `state` (see fill_plan.h); the new walls stand along the directions and
/// still want leaning. surface.sourceFace is −1 on them. Pins that filling buries lie inside. Errors:
/// Internal, Cancelled; of the solid, Worker too.
[[nodiscard]] Result<PartedPart> filledSurface(const IndexedMesh& part, const MoldState& state,
                                               FillExtent extent, const Task& task,
                                               const std::vector<PlacedPin>& pins = {});
[[nodiscard]] Result<PartedSolid> filledSolid(const IndexedMesh& part, const MoldState& state,
                                              FillExtent extent, const Task& task,
                                              const std::vector<PlacedPin>& pins = {});

/// The part with all filled that cannot leave, the walls leaning by the draft already (see fillWithDraft()):
/// nothing is left to bend. Errors: Internal, Cancelled.
[[nodiscard]] Result<PartedPart> filledWithDraft(const IndexedMesh& part, const MoldState& state,
                                                 double draftDegrees, const Task& task,
                                                 const std::vector<PlacedPin>& pins = {});

/// Whether the topological certificate holds for the part at `state`.
[[nodiscard]] bool planePasses(const IndexedMesh& part, const MoldState& state);

/// What can never be cast of the part at one state.
struct ObstructedPart {
    std::vector<Obstruction> obstructions; ///< none where planePasses()
    PartedMesh surface;                    ///< the part with its parting line, working frame
};

/// The obstructions of the part at `state`.
[[nodiscard]] ObstructedPart obstructionsAt(const IndexedMesh& part, const MoldState& state);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "castability/parting_line.h"
#include "castability/plane_search.h"
#include "design/design.h"
#include "design/placed_pin.h"
#include "design/working_frame.h"
#include "mesh/tet_mesh.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace moldwright {

/// The part parted by a plane, filled where that was asked for.
struct PartedPart {
    MoldState state; ///< part frame
    WorkingFrame frame;
    PartedMesh surface;            ///< working frame
    double filledVolume = 0;       ///< mm³ that filling added
    bool joinsPieces = false;      ///< filling made one of pieces that were apart, without being told to
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

/// The part in the working frame with its parting line inserted, ever closer to where it lies: points within
/// these shares of the shortest edge are snapped to the plane.
inline constexpr std::array kSnaps = {0.25, 0.1, 0.02, 0.0};

/// What takes a parted surface with its pins (working frame), or refuses it and why.
using Taking = std::function<std::optional<Error>(const PartedMesh&, const std::vector<PlacedPin>&)>;

/// Takes any surface.
[[nodiscard]] std::optional<Error> takeAny(const PartedMesh&, const std::vector<PlacedPin>&);

/// Takes a surface when TetGen fills it; the tetrahedra go to `tets`.
[[nodiscard]] Taking takeTetrahedralized(TetMesh& tets, const Task& task);

/// A parted part with the tetrahedra that were made on taking it.
[[nodiscard]] Result<PartedSolid> solidOf(Result<PartedPart> part, TetMesh tets);

/// Why a parting line was refused that makes the surface cross itself, or that misses a pin.
[[nodiscard]] Error crossesItself();
[[nodiscard]] Error missesPin();

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

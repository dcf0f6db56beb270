// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/parting.h"

#include <vector>

namespace moldwright {

/// The pins in the working frame, at z = 0 exactly.
[[nodiscard]] std::vector<PlacedPin> pinsToWork(std::vector<PlacedPin> pins, const WorkingFrame& frame);

/// `mesh` (working frame) with its pinned points at z = 0 and the plane passing through them: where the
/// surface would only touch the plane there, the neighbour nearest to it is brought across, by a share of an
/// edge. A parting line can then run through the point.
[[nodiscard]] IndexedMesh withPinsInPlane(IndexedMesh mesh, const std::vector<PlacedPin>& pins);

/// Whether all pinned points of the surface are in the plane.
[[nodiscard]] bool pinsAreInPlane(const IndexedMesh& mesh, const std::vector<PlacedPin>& pins);

/// The pins of a surface that filling changed: `sourceVertex` says which point each of its points was, −1
/// none. A pinned point that is gone was buried.
[[nodiscard]] std::vector<PlacedPin> pinsAfterFilling(std::vector<PlacedPin> pins,
                                                      const std::vector<int>& sourceVertex);

/// The parted surface (part frame) with its points where they were in `original`, of which pins made `shape`,
/// the surface that was parted. Where filling made new faces: as it was parted.
[[nodiscard]] IndexedMesh beforePinning(const PartedPart& part, const IndexedMesh& shape,
                                        const IndexedMesh& original);

/// Where the pins of a bent part are in its cast (part frame): those inside where bending left them, those on
/// the surface where their point is, or, where clean-up merged it into another of the parting line, the
/// nearest of these. `sourceVertex`: the point of the part that each of the cast's was.
[[nodiscard]] std::vector<PinnedPoint> pinnedPoints(const std::vector<PlacedPin>& pins,
                                                    const PartedPart& part, const IndexedMesh& cast,
                                                    const std::vector<int>& sourceVertex);

} // namespace moldwright

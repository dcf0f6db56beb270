// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/block.h"
#include "mold/surface_sum.h"

#include <optional>
#include <vector>

namespace moldwright {

/// The surfaces that one half shows to what is not air, each looking out of the solid it belongs to and open
/// where it meets the parting plane or the block's faces.
struct HalfSurfaces {
    /// Cavities, channels, sockets, slits: turned inside out they bound the half.
    std::vector<PlacedSurface> voids;
    std::vector<PlacedSurface> bosses; ///< keys: they belong to it
};

/// Mold half `side`: a graph over the plane, so no boolean operation is needed. Its surfaces, and flat faces
/// that close them: the parting face, the block's walls with the mouths of spout and slits, its top with
/// those of vents. Surfaces that meet must have their points in common, to the bit. None where borders cross.
[[nodiscard]] std::optional<IndexedMesh> assembleHalf(int side, const HalfSurfaces& surfaces,
                                                      const Block& block);

/// The faces of a closed solid in the mold's frame that lie on one side of the parting plane, but for those
/// in the block's outer face at z = `end`, where something comes out.
[[nodiscard]] IndexedMesh sideOf(const IndexedMesh& solid, int side, double end);

} // namespace moldwright

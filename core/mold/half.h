// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "mold/block.h"

#include <optional>
#include <vector>

namespace moldwright {

/// The surfaces that one half shows to what is not air, each looking out of the solid it belongs to and open
/// where it meets the parting plane or the block's faces.
struct HalfSurfaces {
    std::vector<IndexedMesh>
        voids; ///< cavities, channels, sockets, slits: turned inside out they bound the half
    std::vector<IndexedMesh> bosses; ///< keys: they belong to it
};

/// Mold half `side`: a graph over the plane, so no boolean operation is needed. Its surfaces, and flat faces
/// that close them: the parting face, the block's walls with the mouths of spout and slits, its top with
/// those of vents. Surfaces that meet must have their points in common, to the bit. None where borders cross.
[[nodiscard]] std::optional<IndexedMesh> assembleHalf(int side, const HalfSurfaces& surfaces,
                                                      const Block& block);

/// Meshes as one, equal points welded.
[[nodiscard]] IndexedMesh weldedTogether(const std::vector<IndexedMesh>& meshes);

/// The mesh inside out.
[[nodiscard]] IndexedMesh insideOut(IndexedMesh mesh);

/// The mesh moved in the plane.
[[nodiscard]] IndexedMesh movedInPlane(IndexedMesh mesh, const Eigen::Vector2d& by);

} // namespace moldwright

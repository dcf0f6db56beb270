// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

/// Whether a mold half, as a mesh, can leave along its direction; found from the meshes alone, without
/// knowing how they were built.
struct HalfRelease {
    bool sound = false; ///< closed, manifold, outward, one component, free of self-intersection
    /// Faces, not on the mold's outside, with −N·d < sin(draft), exact; but for those in free air, that
    /// nothing touches or meets: bores, lettering.
    std::vector<int> stuckFaces;
    std::vector<int> sweptFaces; ///< faces from whose centre a ray along d meets the cast or the other half
    [[nodiscard]] bool freeToMove() const { return stuckFaces.empty() && sweptFaces.empty(); }
};

/// Examines `half` of a mold whose other parts are `other` and `cast`, all in one frame, moving along d.
/// A face is on the outside when no point of the mold lies beyond its plane. The rays are a test independent
/// of the proof by angles: any fixed distance moved would show as a hit. O(m) on even meshes.
[[nodiscard]] HalfRelease examineRelease(const IndexedMesh& half, const IndexedMesh& other,
                                         const IndexedMesh& cast, const Eigen::Vector3d& d,
                                         double draftDegrees);

/// Whether no ray from a face of `half` along d meets `other`: for the motion of one half against the other
/// when both leave at once, d ∝ d1 − d2.
[[nodiscard]] bool leavesOther(const IndexedMesh& half, const IndexedMesh& other, const Eigen::Vector3d& d);

} // namespace moldwright

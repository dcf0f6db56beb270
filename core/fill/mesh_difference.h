// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/parting_line.h"

#include <array>
#include <vector>

namespace moldwright {

/// Where two closed labelled meshes agree, face by face, and the patches where they do not. A patch of the
/// one and its counterpart of the other end at the same edges, so that each can take the other's place.
struct MeshDifference {
    Points points;                           ///< of both meshes, equal ones once
    std::array<Triangles, 2> faces;          ///< the first mesh's and the second's, over these points
    std::array<std::vector<int>, 2> patchOf; ///< per face its patch, −1 where both meshes have it
    int patches = 0;
};

/// Points are equal where their coordinates are.
[[nodiscard]] MeshDifference meshDifference(const PartedMesh& first, const PartedMesh& second);

} // namespace moldwright

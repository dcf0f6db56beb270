// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <array>
#include <vector>

namespace moldwright {

/// What a plane cuts through a solid.
struct Section {
    IndexedMesh fill;                        ///< triangles in the plane, facing along its normal, mm
    std::vector<std::array<int, 2>> outline; ///< its border, as pairs of points of `fill`
    double area = 0;                         ///< mm²
};

/// The section at which the part of a closed mesh that lies behind the plane (n·x < o) ends. Points nearer to
/// the plane than a millionth of the mesh's size count as in it; faces in it bound the section of their own
/// solid only. Empty where the plane misses the mesh. O(m) and a triangulation of the outline.
[[nodiscard]] Section sectionOf(const IndexedMesh& mesh, const PartingPlane& cut);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <Eigen/Geometry>

#include <vector>

namespace moldwright {

/// Signed volume enclosed by a closed mesh, mm³; positive when its faces look outward.
[[nodiscard]] double volume(const IndexedMesh& mesh);

/// Total area of the faces, mm².
[[nodiscard]] double surfaceArea(const IndexedMesh& mesh);

/// Twice the area vector of face f: (b−a)×(c−a), mm². Its length is twice the area, its direction the normal.
[[nodiscard]] inline Eigen::Vector3d doubleAreaVector(const IndexedMesh& mesh, int f) {
    const Eigen::Vector3d a = mesh.corner(f, 0);
    return (mesh.corner(f, 1) - a).cross(mesh.corner(f, 2) - a);
}

/// Bounding box of the vertices that faces use, mm.
[[nodiscard]] Eigen::AlignedBox3d boundingBox(const IndexedMesh& mesh);

/// Length of the bounding box's diagonal, mm.
[[nodiscard]] double diagonal(const IndexedMesh& mesh);

/// Centre of mass of the enclosed solid, mm. Precondition: closed, volume ≠ 0.
[[nodiscard]] Eigen::Vector3d centroid(const IndexedMesh& mesh);

/// Connected component of each face (sharing a vertex), numbered from 0 in order of first face; and their
/// count.
struct Components {
    std::vector<int> ofFace;
    int count = 0;
};
[[nodiscard]] Components connectedComponents(const IndexedMesh& mesh);

} // namespace moldwright

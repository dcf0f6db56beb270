// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

namespace moldwright {

/// True when two corners of face f are one point, as welding can make them.
[[nodiscard]] inline bool usesAPointTwice(const IndexedMesh& mesh, int f) {
    return mesh.F(f, 0) == mesh.F(f, 1) || mesh.F(f, 1) == mesh.F(f, 2) || mesh.F(f, 2) == mesh.F(f, 0);
}

/// A mesh whose points were merged, and how many points that saved.
struct WeldedMesh {
    IndexedMesh mesh;
    int merged = 0;
};

/// Merges points with equal coordinates (0 equals −0). Points keep the order of their first appearance.
[[nodiscard]] WeldedMesh weldEqualPoints(const IndexedMesh& mesh);

/// Merges points within `distance` of each other (same unit as the points): each point joins the first
/// earlier point in reach. Near-linear unless most points lie within `distance` of each other.
[[nodiscard]] WeldedMesh weldNearPoints(const IndexedMesh& mesh, double distance);

/// Removes points that no face uses; the others keep their order.
[[nodiscard]] WeldedMesh withoutUnusedPoints(const IndexedMesh& mesh);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/message.h"
#include "base/result.h"
#include "mesh/indexed_mesh.h"

#include <utility>
#include <vector>

namespace moldwright {

/// What is true of a mesh, found without changing it.
struct MeshDiagnosis {
    bool closed = false;   ///< every edge has a face on both sides
    bool manifold = false; ///< at most two faces an edge, one fan of faces a vertex
    bool oriented = false; ///< neighbours agree, and the whole looks outward (positive volume)
    int boundaryLoops = 0;
    int components = 0;
    int genus = 0;                    ///< summed over components; meaningful when closed and manifold
    std::vector<int> degenerateFaces; ///< of exactly zero area
    std::vector<int> badFaces;        ///< faces at open or non-manifold edges and vertices
    std::vector<std::pair<int, int>>
        selfIntersections; ///< pairs of faces that cross or touch (not only neighbours)
    double volume = 0;     ///< mm³

    /// Closed, manifold, oriented, one solid of positive volume, no degenerate face, no self-intersection.
    [[nodiscard]] bool usable() const;
};

/// Diagnoses `mesh`. Self-intersections by exact predicates (CGAL); near-linear in the number of faces.
[[nodiscard]] MeshDiagnosis diagnose(const IndexedMesh& mesh);

/// Pairs of faces that intersect other than at shared vertices and edges; exact predicates.
[[nodiscard]] std::vector<std::pair<int, int>> selfIntersections(const IndexedMesh& mesh);

/// A mesh that can be designed with, and what was done to make it so.
struct PreparedMesh {
    IndexedMesh mesh;
    std::vector<Message> repairs; ///< "5 equal points welded", "orientation of 442 faces turned", …
};

/// Drops unused points, welds equal points, drops repeated-index faces, mends orientation; then requires
/// usable(). `name` is the file's name for messages. Errors: BadInput saying what is wrong, how many and
/// where (faces, places).
[[nodiscard]] Result<PreparedMesh> prepare(const IndexedMesh& mesh, const std::string& name);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/message.h"
#include "base/result.h"
#include "mesh/indexed_mesh.h"

#include <string>
#include <utility>
#include <vector>

namespace moldwright {

/// What is true of a mesh, found without changing it. Lists are in ascending order.
struct MeshDiagnosis {
    bool closed = false;   ///< every edge has a face on both sides
    bool manifold = false; ///< at most two faces an edge, one fan of faces a vertex
    bool oriented = false; ///< neighbours agree, and every component looks outward (positive volume)
    int boundaryLoops = 0; ///< groups of open edges that hang together
    int components = 0;    ///< disjoint solids are allowed; see nested
    int nested = 0;        ///< components inside another; known when closed, manifold, not self-intersecting
    int genus = 0;         ///< summed over components; known when closed and manifold
    std::vector<int> degenerateFaces; ///< of exactly zero area, or using a point twice
    std::vector<int> openFaces;       ///< at edges that no other face shares
    std::vector<int> crowdedFaces;    ///< at edges that more than two faces share
    std::vector<int> pinchedPoints;   ///< points where several fans of faces meet
    std::vector<std::pair<int, int>>
        selfIntersections; ///< pairs of faces that cross or touch (not only neighbours)
    double volume = 0;     ///< mm³

    /// Closed, manifold, oriented, of positive volume, none nested, no degenerate face, no self-intersection.
    [[nodiscard]] bool usable() const;
};

/// Diagnoses `mesh`. Self-intersections by exact predicates (CGAL); near-linear in the number of faces.
[[nodiscard]] MeshDiagnosis diagnose(const IndexedMesh& mesh);

/// Pairs (f < g) of faces that intersect other than at points and edges they share, in ascending order; faces
/// without area are left out. Exact predicates; near-linear, the same for any number of threads.
[[nodiscard]] std::vector<std::pair<int, int>> selfIntersections(const IndexedMesh& mesh);

/// Faces whose corners lie on one line, exactly, in ascending order.
[[nodiscard]] std::vector<int> flatFaces(const IndexedMesh& mesh);

/// A mesh after everything that can be mended without a choice was mended, and what is true of it then.
struct Examination {
    IndexedMesh mesh;
    std::vector<Message> repairs; ///< "5 equal points were welded.", "442 faces were turned.", …
    std::vector<Message> notes;   ///< what is unusual but allowed: "It consists of 2 separate solids."
    MeshDiagnosis diagnosis;      ///< of `mesh`
    std::vector<Error> faults;    ///< why it cannot be designed with, the gravest first; none: it can
};

/// Drops unused points, welds equal points (near ones too, within 1e-6 of the diagonal, where that closes an
/// open surface), drops repeated faces and faces that use a point twice, turns faces so that all look
/// outward. Nothing else is changed. `name` is the file's name for messages. Faults are BadInput, saying what
/// is wrong, how many and where (faces: of the mesh as given; places).
[[nodiscard]] Examination examine(const IndexedMesh& mesh, const std::string& name);

/// A mesh that can be designed with, and what was done to make it so.
struct PreparedMesh {
    IndexedMesh mesh;
    std::vector<Message> repairs;
    std::vector<Message> notes;
};

/// What examine() makes of `mesh`, if it is usable() then. Errors: BadInput, the gravest fault.
[[nodiscard]] Result<PreparedMesh> prepare(const IndexedMesh& mesh, const std::string& name);

} // namespace moldwright

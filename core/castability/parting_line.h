// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

/// A mesh with its parting line as edges: no face has points on both sides of the plane.
struct PartedMesh {
    IndexedMesh mesh;            ///< in the plane's frame; points on the parting line have z = 0 exactly
    SideLabels labels;           ///< 1 or 2 per face
    std::vector<int> sourceFace; ///< per face: the face of the input it is, or is a piece of
};

/// Inserts the parting line of the plane z = 0 into a closed mesh given in the plane's frame: points nearer
/// to the plane than `snap` times their shortest edge are moved onto it, edges that cross it are split
/// (OpenMesh), faces get their side. A face in the plane belongs to side 1 if it looks up, else to side 2.
/// Points that would touch the plane without crossing it, and points where the line would meet itself, are
/// pushed off the plane by a quarter of their shortest edge at most: the line is simple. Vertices of the
/// input keep their index. snap in [0, 0.25]: more makes rounder faces, less changes the shape less.
[[nodiscard]] PartedMesh insertPartingLine(const IndexedMesh& mesh, double snap);

/// `mesh` (plane's frame) with points brought across the plane that lie within `reach` of it and whose faces
/// look clearly at the other side: the web in an armpit, the lip over a seam. On their own side such faces
/// could leave only if the parting line crossed itself; on the other they need no bending at all. Points move
/// along z alone.
[[nodiscard]] IndexedMesh crossNearPoints(const IndexedMesh& mesh, double reach);

/// The directed edges a→b of the parting line with side 1 on their left, by face labels.
[[nodiscard]] std::vector<std::array<int, 2>> partingEdges(const IndexedMesh& mesh, const SideLabels& labels);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <Eigen/Core>

#include <vector>

namespace moldwright {

/// A closed chain of the parting line as one side sees it: the side's surface on its left.
struct PartingLoop {
    std::vector<int> vertices;
    double signedArea = 0; ///< in the plane's frame, seen from the side: positive runs counter-clockwise
};

/// A connected part of one side's surface.
struct SidePiece {
    int side = 0;
    std::vector<int> faces;
    std::vector<PartingLoop> loops;
    int genus = 0;
};

/// The connected pieces of both sides, in order of their first face. `mesh` in the plane's frame.
[[nodiscard]] std::vector<SidePiece> sidePieces(const IndexedMesh& mesh, const SideLabels& labels);

/// Why a piece can never be a graph over the plane, however it is bent.
enum class PieceFault {
    None,
    Closed, ///< no parting line: a cavity, or a whole component on one side
    Handle, ///< genus > 0
    Arch,   ///< more than one outer loop: it spans a gap
    Pocket  ///< no outer loop: it hangs over air
};

/// The topological certificate of one piece: genus 0, exactly one loop that runs counter-clockwise, all
/// others clockwise and inside it. Necessary for castability with these labels; a deformation that keeps the
/// loops simple keeps it. See ARCHITECTURE.md, "The topological certificate".
[[nodiscard]] PieceFault pieceFault(const IndexedMesh& mesh, const SidePiece& piece);

/// Whether every piece of both sides passes.
[[nodiscard]] bool topologyAllowsCasting(const IndexedMesh& mesh, const SideLabels& labels);

} // namespace moldwright

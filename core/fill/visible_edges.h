// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fill/face_grid.h"
#include "fill/projected_half.h"

#include <array>
#include <utility>
#include <vector>

namespace moldwright {

/// What of a half's edges an eye far out along the direction sees: the lines that bound what is seen of its
/// faces, and the shadows that silhouettes cast on the faces below them.
struct VisibleEdges {
    std::vector<Eigen::Vector2d> nodes;       ///< the half's, then those where something begins to be hidden
    std::vector<std::array<int, 2>> segments; ///< between nodes
    std::vector<std::pair<int, int>> nodeOnEdge; ///< ascending: a new node and an edge of the half it lies on
};

/// Edges are cut only where they vanish below a silhouette, and silhouettes where an edge emerges below them,
/// so that faces are not split without need.
[[nodiscard]] VisibleEdges findVisibleEdges(const ProjectedHalf& half, const FaceGrid& grid);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

/// The edges of a mesh as a graph on its points, ready for shortest paths.
class EdgeGraph {
public:
    explicit EdgeGraph(const IndexedMesh& mesh);

    /// Length of the shortest path along edges from the sources to each point, mesh units; infinity where
    /// none leads. An upper bound of the geodesic distance, some per cent above it: fit for ratios.
    [[nodiscard]] std::vector<double> distances(const std::vector<int>& sources) const;

    [[nodiscard]] const std::vector<int>& neighbours(int v) const {
        return m_neighbours[static_cast<std::size_t>(v)];
    }
    [[nodiscard]] int size() const { return static_cast<int>(m_neighbours.size()); }

private:
    std::vector<std::vector<int>> m_neighbours;
    std::vector<std::vector<double>> m_lengths;
};

/// Points at the ends of limbs: local maxima of the mean distance to the whole surface whose prominence is at
/// least `prominence` (mesh units). Most prominent first.
[[nodiscard]] std::vector<int> limbTips(const EdgeGraph& graph, double prominence);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <span>
#include <vector>

namespace moldwright {

/// One face's side at an edge: it runs from corner k to corner k+1 of the face.
struct FaceSide {
    int low = 0; ///< the edge's points, low < high
    int high = 0;
    int face = 0;
    int corner = 0;
    bool upward = true; ///< the side runs from low to high
};

/// All edges of any set of triangles, manifold or not, each with the faces that share it. Edges are in the
/// order of their points; the faces of an edge in the order of their indices. Precondition: no face uses a
/// point twice.
class EdgeTable {
public:
    explicit EdgeTable(const Triangles& F);

    [[nodiscard]] int edgeCount() const { return static_cast<int>(m_first.size()) - 1; }

    /// The faces at edge e; a closed manifold mesh has two at each.
    [[nodiscard]] std::span<const FaceSide> sidesAt(int e) const {
        const auto at = static_cast<std::size_t>(e);
        return std::span(m_sides).subspan(m_first[at], m_first[at + 1] - m_first[at]);
    }

    /// True when every edge has exactly two faces.
    [[nodiscard]] bool closedManifold() const;

private:
    std::vector<FaceSide> m_sides;
    std::vector<std::size_t> m_first;
};

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <span>
#include <vector>

namespace moldwright {

/// Which faces lie about each point and beyond each side of a mesh. Made in O(n + m).
class FaceNeighbours {
public:
    explicit FaceNeighbours(SharedMesh mesh);

    [[nodiscard]] const IndexedMesh& mesh() const { return *m_mesh; }

    /// The faces that use point v, in ascending order.
    [[nodiscard]] std::span<const int> around(int v) const {
        const auto at = static_cast<std::size_t>(v);
        return std::span(m_faces).subspan(m_first[at], m_first[at + 1] - m_first[at]);
    }

    /// The face beyond the side of face f from its corner k to the next; −1 where there is none.
    [[nodiscard]] int across(int f, int k) const;

private:
    SharedMesh m_mesh;
    std::vector<std::size_t> m_first; ///< per point, and one more: where its faces begin
    std::vector<int> m_faces;
};

/// The faces that are reached from face f over sides creased by no more than `creaseDegrees`, ascending; with
/// 180 the whole connected piece.
[[nodiscard]] std::vector<int> smoothPatch(const FaceNeighbours& neighbours, int f, double creaseDegrees);

} // namespace moldwright

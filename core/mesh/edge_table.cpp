// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/edge_table.h"

#include <algorithm>
#include <tuple>

namespace moldwright {

EdgeTable::EdgeTable(const Triangles& F) {
    m_sides.reserve(static_cast<std::size_t>(F.size()));
    for (int f = 0; f < F.rows(); ++f)
        for (int k = 0; k < 3; ++k) {
            const int from = F(f, k);
            const int to = F(f, (k + 1) % 3);
            m_sides.push_back({std::min(from, to), std::max(from, to), f, k, from < to});
        }
    std::sort(m_sides.begin(), m_sides.end(), [](const FaceSide& a, const FaceSide& b) {
        return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
    });
    for (std::size_t i = 0; i < m_sides.size(); ++i)
        if (i == 0 || m_sides[i].low != m_sides[i - 1].low || m_sides[i].high != m_sides[i - 1].high)
            m_first.push_back(i);
    m_first.push_back(m_sides.size());
}

bool EdgeTable::closedManifold() const {
    for (int e = 0; e < edgeCount(); ++e)
        if (sidesAt(e).size() != 2)
            return false;
    return true;
}

} // namespace moldwright

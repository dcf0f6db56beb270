// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/edge_table.h"

#include "base/stop_point.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace moldwright {

EdgeTable::EdgeTable(const Triangles& F) {
    // By their lower point first: so few are left to sort at each.
    std::vector<std::size_t> end(F.size() == 0 ? 1 : static_cast<std::size_t>(F.maxCoeff()) + 2, 0);
    const auto lowOf = [&](Eigen::Index f, int k) { return std::min(F(f, k), F(f, (k + 1) % 3)); };
    for (Eigen::Index f = 0; f < F.rows(); ++f) {
        stopPointAt(f);
        for (int k = 0; k < 3; ++k)
            ++end[static_cast<std::size_t>(lowOf(f, k)) + 1];
    }
    std::partial_sum(end.begin(), end.end(), end.begin());
    const std::vector<std::size_t> begin = end;
    m_sides.resize(static_cast<std::size_t>(F.size()));
    for (int f = 0; f < F.rows(); ++f) {
        stopPointAt(f);
        for (int k = 0; k < 3; ++k) {
            const int from = F(f, k);
            const int to = F(f, (k + 1) % 3);
            m_sides[end[static_cast<std::size_t>(lowOf(f, k))]++] = {std::min(from, to), std::max(from, to),
                                                                     f, k, from < to};
        }
    }
    for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
        stopPointAt(static_cast<std::ptrdiff_t>(v));
        std::sort(m_sides.begin() + static_cast<std::ptrdiff_t>(begin[v]),
                  m_sides.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]),
                  [](const FaceSide& a, const FaceSide& b) {
                      return std::tie(a.high, a.face) < std::tie(b.high, b.face);
                  });
    }
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

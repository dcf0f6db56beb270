// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace moldwright {

/// Groups of the numbers 0 … count−1 that grow together; a group is known by its root.
class UnionFind {
public:
    explicit UnionFind(int count) : m_parent(static_cast<std::size_t>(count)) {
        std::iota(m_parent.begin(), m_parent.end(), 0);
    }

    int rootOf(int i) {
        while (parent(i) != i) {
            parent(i) = parent(parent(i));
            i = parent(i);
        }
        return i;
    }

    /// Joins the groups of a and b; the smaller root stays.
    void unite(int a, int b) {
        a = rootOf(a);
        b = rootOf(b);
        if (a < b)
            parent(b) = a;
        else
            parent(a) = b;
    }

private:
    int& parent(int i) { return m_parent[static_cast<std::size_t>(i)]; }
    std::vector<int> m_parent;
};

} // namespace moldwright

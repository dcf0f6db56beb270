// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/supernodal_solve.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace moldwright {

namespace {

/// Below so many numbers waking a second core costs more than it gains.
constexpr double kSmallFactor = 1.5e5;
/// Subtrees are divided until none has more than this share of the factor; what is lighter than the other
/// joins what is solved by one thread.
constexpr double kLargestShare = 0.3;
constexpr double kSmallestShare = 0.01;

/// The elimination tree of a factor's supernodes, children before parents, each subtree in one run.
struct Tree {
    std::vector<std::vector<int>> children;
    std::vector<int> roots;
    std::vector<int> first;     ///< supernode of each one's subtree
    std::vector<double> weight; ///< numbers in the factor of each one's subtree
};

Tree treeOf(const SupernodalFactor& L) {
    const auto count = static_cast<std::size_t>(L.supernodes);
    Tree tree{
        std::vector<std::vector<int>>(count), {}, std::vector<int>(count), std::vector<double>(count, 0.0)};
    std::vector<int> supernodeOf(static_cast<std::size_t>(L.size));
    for (int s = 0; s < L.supernodes; ++s)
        std::fill(supernodeOf.begin() + L.firstColumn[s], supernodeOf.begin() + L.firstColumn[s + 1], s);
    std::iota(tree.first.begin(), tree.first.end(), 0);
    for (int s = 0; s < L.supernodes; ++s) {
        const auto at = static_cast<std::size_t>(s);
        const int columns = L.firstColumn[s + 1] - L.firstColumn[s];
        const int rows = L.firstRow[s + 1] - L.firstRow[s];
        tree.weight[at] += static_cast<double>(columns) * rows;
        if (rows == columns) {
            tree.roots.push_back(s);
            continue;
        }
        const int parent = supernodeOf[static_cast<std::size_t>(L.rows[L.firstRow[s] + columns])];
        const auto above = static_cast<std::size_t>(parent);
        tree.children[above].push_back(s);
        tree.weight[above] += tree.weight[at];
        tree.first[above] = std::min(tree.first[above], tree.first[at]);
    }
    return tree;
}

/// Roots of the subtrees to be solved side by side, ascending.
std::vector<int> divide(const Tree& tree) {
    const auto weightOf = [&](int s) { return tree.weight[static_cast<std::size_t>(s)]; };
    double total = 0;
    for (const int root : tree.roots)
        total += weightOf(root);
    std::vector<int> open;
    std::vector<int> done;
    if (total > kSmallFactor)
        open = tree.roots;
    while (!open.empty()) {
        const int s = open.back();
        open.pop_back();
        if (weightOf(s) > kLargestShare * total)
            open.insert(open.end(), tree.children[static_cast<std::size_t>(s)].begin(),
                        tree.children[static_cast<std::size_t>(s)].end());
        else if (weightOf(s) >= kSmallestShare * total)
            done.push_back(s);
    }
    std::sort(done.begin(), done.end());
    return done;
}

} // namespace

SolvePlan::SolvePlan(const SupernodalFactor& L) {
    const Tree tree = treeOf(L);
    std::vector<int> subtreeOf(static_cast<std::size_t>(L.supernodes), -1);
    for (const int root : divide(tree)) {
        const int first = tree.first[static_cast<std::size_t>(root)];
        std::fill(subtreeOf.begin() + first, subtreeOf.begin() + root + 1, static_cast<int>(subtrees.size()));
        subtrees.push_back({first, root + 1, 0, 0});
    }
    std::vector<int> joiningIndex(static_cast<std::size_t>(L.size), -1);
    for (int s = 0; s < L.supernodes; ++s) {
        if (subtreeOf[static_cast<std::size_t>(s)] >= 0)
            continue;
        joining.push_back(s);
        for (int row = L.firstColumn[s]; row < L.firstColumn[s + 1]; ++row) {
            joiningIndex[static_cast<std::size_t>(row)] = static_cast<int>(joiningRows.size());
            joiningRows.push_back(row);
        }
    }
    for (Subtree& subtree : subtrees) {
        subtree.ownPlace = places;
        places += L.firstColumn[subtree.endSupernode] - L.firstColumn[subtree.firstSupernode];
        subtree.joiningPlace = places;
        places += static_cast<int>(joiningRows.size());
    }
    joiningPlace = places;
    places += static_cast<int>(joiningRows.size());
    place.resize(static_cast<std::size_t>(L.firstRow[L.supernodes]));
    for (int s = 0; s < L.supernodes; ++s) {
        const int at = subtreeOf[static_cast<std::size_t>(s)];
        const Subtree* subtree = at < 0 ? nullptr : &subtrees[static_cast<std::size_t>(at)];
        for (int i = L.firstRow[s]; i < L.firstRow[s + 1]; ++i) {
            const int index = joiningIndex[static_cast<std::size_t>(L.rows[i])];
            place[static_cast<std::size_t>(i)] =
                index >= 0 ? (subtree ? subtree->joiningPlace : joiningPlace) + index
                           : subtree->ownPlace + L.rows[i] - L.firstColumn[subtree->firstSupernode];
        }
    }
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/point_groups.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace moldwright {

namespace {

using Index = std::vector<int>::iterator;

/// Halves what is too many across its longest side, in place.
void addGroups(const Points& V, Index begin, Index end, int most, std::vector<PointGroup>& groups) {
    PointGroup group;
    for (auto v = begin; v != end; ++v)
        group.box.extend(V.row(*v).transpose());
    if (std::distance(begin, end) <= most) {
        group.points.assign(begin, end);
        std::sort(group.points.begin(), group.points.end());
        groups.push_back(std::move(group));
        return;
    }
    Eigen::Index axis = 0;
    group.box.sizes().maxCoeff(&axis);
    const auto middle = begin + std::distance(begin, end) / 2;
    std::nth_element(begin, middle, end, [&](int a, int b) {
        return V(a, axis) != V(b, axis) ? V(a, axis) < V(b, axis) : a < b;
    });
    addGroups(V, begin, middle, most, groups);
    addGroups(V, middle, end, most, groups);
}

} // namespace

std::vector<PointGroup> groupsOfPoints(const Points& V, int most) {
    std::vector<int> all(static_cast<std::size_t>(V.rows()));
    std::iota(all.begin(), all.end(), 0);
    std::vector<PointGroup> groups;
    if (!all.empty())
        addGroups(V, all.begin(), all.end(), std::max(most, 1), groups);
    return groups;
}

} // namespace moldwright

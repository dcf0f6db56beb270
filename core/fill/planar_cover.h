// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace moldwright {

/// Directed edges, each counted; those that run both ways cancel.
class DirectedEdges {
public:
    void add(int from, int to);
    [[nodiscard]] bool empty() const { return m_times.empty(); }

    /// How often more the edge runs this way than back.
    [[nodiscard]] int times(int from, int to) const;

    /// In the order of their points, each as often as it counts.
    [[nodiscard]] std::vector<std::pair<int, int>> list() const;

private:
    std::map<std::pair<int, int>, int> m_times; ///< lower point first
};

/// What a border in the plane encloses, as triangles.
struct PlanarCover {
    std::vector<Eigen::Vector2d> points;       ///< those given, then those where the border crosses itself
    std::vector<std::vector<int>> chains;      ///< per segment the points along it, its ends included
    std::vector<std::array<int, 3>> triangles; ///< running round as the border does
};

/// Covers what closed loops of directed segments enclose: counter-clockwise where they run so, clockwise
/// where they run round the other way, as a loop that crosses itself does. None where points coincide or the
/// loops run round anything twice.
[[nodiscard]] std::optional<PlanarCover> coverBorder(const std::vector<Eigen::Vector2d>& points,
                                                     const std::vector<std::array<int, 2>>& segments);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/planar_cover.h"

#include "fill/cgal/planar_triangulation.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <set>

namespace moldwright {

namespace {

bool allApart(const std::vector<Eigen::Vector2d>& points) {
    std::set<std::pair<double, double>> places;
    return std::all_of(points.begin(), points.end(),
                       [&](const Eigen::Vector2d& p) { return places.emplace(p.x(), p.y()).second; });
}

/// How often the border runs round each triangle: known outside, it changes by what is crossed on the way in.
std::vector<int> windingOf(const PlanarTriangulation& plane, const DirectedEdges& border) {
    std::vector<int> winding(plane.triangles.size(), 0);
    std::vector<char> known(winding.size(), 0);
    std::queue<std::size_t> open;
    const auto step = [&](std::size_t t, std::size_t k) {
        return border.times(plane.triangles[t][k], plane.triangles[t][(k + 1) % 3]);
    };
    const auto enter = [&](std::size_t t, int times) {
        if (std::exchange(known[t], 1))
            return;
        winding[t] = times;
        open.push(t);
    };
    for (std::size_t t = 0; t < winding.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            if (plane.neighbours[t][k] < 0)
                enter(t, step(t, k));
    for (; !open.empty(); open.pop()) {
        const std::size_t t = open.front();
        for (std::size_t k = 0; k < 3; ++k)
            if (plane.neighbours[t][k] >= 0)
                enter(static_cast<std::size_t>(plane.neighbours[t][k]), winding[t] - step(t, k));
    }
    return winding;
}

} // namespace

void DirectedEdges::add(int from, int to) {
    const auto place = m_times.emplace(std::minmax(from, to), 0).first;
    place->second += from < to ? 1 : -1;
    if (place->second == 0)
        m_times.erase(place);
}

int DirectedEdges::times(int from, int to) const {
    const auto found = m_times.find(std::minmax(from, to));
    return found == m_times.end() ? 0 : from < to ? found->second : -found->second;
}

std::vector<std::pair<int, int>> DirectedEdges::list() const {
    std::vector<std::pair<int, int>> edges;
    for (const auto& [edge, times] : m_times)
        edges.insert(edges.end(), static_cast<std::size_t>(std::abs(times)),
                     times > 0 ? edge : std::pair{edge.second, edge.first});
    return edges;
}

std::optional<PlanarCover> coverBorder(const std::vector<Eigen::Vector2d>& points,
                                       const std::vector<std::array<int, 2>>& segments) {
    if (!allApart(points))
        return std::nullopt;
    CrossedSegments crossed = crossSegments(points, segments);
    const PlanarTriangulation& plane = crossed.triangulation;
    PlanarCover cover{plane.points, std::move(crossed.chains), {}};
    DirectedEdges border;
    for (std::size_t s = 0; s < segments.size(); ++s) {
        std::vector<int>& chain = cover.chains[s];
        if (chain.front() != segments[s][0])
            std::reverse(chain.begin(), chain.end());
        for (std::size_t i = 0; i + 1 < chain.size(); ++i)
            border.add(chain[i], chain[i + 1]);
    }
    const std::vector<int> winding = windingOf(plane, border);
    for (std::size_t t = 0; t < winding.size(); ++t) {
        if (std::abs(winding[t]) > 1)
            return std::nullopt;
        const auto& [a, b, c] = plane.triangles[t];
        if (winding[t] != 0)
            cover.triangles.push_back(winding[t] > 0 ? std::array{a, b, c} : std::array{a, c, b});
    }
    return cover;
}

} // namespace moldwright

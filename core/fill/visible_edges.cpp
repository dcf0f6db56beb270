// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/visible_edges.h"

#include "base/parallel.h"
#include "mesh/touching_boxes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <unordered_map>

namespace moldwright {

namespace {

constexpr double kSameHeight = 0.5; ///< grid steps
constexpr std::size_t kGrain = 256;

/// A silhouette passing over another edge; t runs from 0 to 1 along an edge.
struct Passing {
    int over = 0;
    int under = 0;
    double tOver = 0;
    double tUnder = 0;
};

double mix(const std::array<double, 2>& ends, double t) {
    return ends[0] + t * (ends[1] - ends[0]);
}

/// Where two edges cross between their ends, e over g or g over e.
std::optional<Passing> crossing(const ProjectedHalf& half, int e, int g) {
    const ShadowEdge& first = half.edges[static_cast<std::size_t>(e)];
    const ShadowEdge& second = half.edges[static_cast<std::size_t>(g)];
    const double c = doubleArea(half.end(first, 0), half.end(first, 1), half.end(second, 0));
    const double d = doubleArea(half.end(first, 0), half.end(first, 1), half.end(second, 1));
    if (!(std::min(c, d) < 0 && std::max(c, d) > 0))
        return std::nullopt;
    const double a = doubleArea(half.end(second, 0), half.end(second, 1), half.end(first, 0));
    const double b = doubleArea(half.end(second, 0), half.end(second, 1), half.end(first, 1));
    if (!(std::min(a, b) < 0 && std::max(a, b) > 0))
        return std::nullopt;
    const double tFirst = a / (a - b);
    const double tSecond = c / (c - d);
    const double above = mix(first.height, tFirst) - mix(second.height, tSecond);
    if (above > kSameHeight && first.silhouette())
        return Passing{e, g, tFirst, tSecond};
    if (above < -kSameHeight && second.silhouette())
        return Passing{g, e, tSecond, tFirst};
    return std::nullopt;
}

/// Where an end of a silhouette lies exactly over another edge, between its ends.
std::optional<Passing> ending(const ProjectedHalf& half, int over, int under, std::size_t end) {
    const ShadowEdge& top = half.edges[static_cast<std::size_t>(over)];
    const ShadowEdge& low = half.edges[static_cast<std::size_t>(under)];
    const Eigen::Vector2d along = half.end(low, 1) - half.end(low, 0);
    const double t = (half.end(top, end) - half.end(low, 0)).dot(along) / along.squaredNorm();
    if (!top.silhouette() || !(t > 0 && t < 1) ||
        doubleArea(half.end(low, 0), half.end(low, 1), half.end(top, end)) != 0 ||
        !(top.height[end] > mix(low.height, t) + kSameHeight))
        return std::nullopt;
    return Passing{over, under, static_cast<double>(end), t};
}

std::vector<Passing> passingsOf(const ProjectedHalf& half, int e, int g) {
    std::vector<Passing> found;
    const auto add = [&](const std::optional<Passing>& passing) {
        if (passing)
            found.push_back(*passing);
    };
    add(crossing(half, e, g));
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        add(ending(half, e, g, end));
        add(ending(half, g, e, end));
    }
    return found;
}

std::vector<Passing> findPassings(const ProjectedHalf& half) {
    IndexedMesh needles; // edges as flat triangles: what the tree of boxes takes
    needles.V = Points::Zero(static_cast<Eigen::Index>(half.nodes.size()), 3);
    for (std::size_t n = 0; n < half.nodes.size(); ++n)
        needles.V.row(static_cast<Eigen::Index>(n)).head<2>() = half.nodes[n].transpose();
    needles.F.resize(static_cast<Eigen::Index>(half.edges.size()), 3);
    for (std::size_t e = 0; e < half.edges.size(); ++e)
        needles.F.row(static_cast<Eigen::Index>(e)) << half.edges[e].node[0], half.edges[e].node[1],
            half.edges[e].node[1];
    std::vector<int> all(half.edges.size());
    std::iota(all.begin(), all.end(), 0);
    const auto pairs = pairsWithTouchingBoxes(needles, all, [&](int e, int g) {
        return (half.edges[static_cast<std::size_t>(e)].silhouette() ||
                half.edges[static_cast<std::size_t>(g)].silhouette()) &&
               !passingsOf(half, e, g).empty();
    });
    std::vector<Passing> passings;
    for (const auto& [e, g] : pairs)
        for (const Passing& passing : passingsOf(half, e, g))
            passings.push_back(passing);
    return passings;
}

/// Which stretches of an edge are seen: stretch i lies between cuts i and i+1.
struct Sight {
    std::vector<double> cuts; ///< 0, …, 1 ascending
    std::vector<char> seen;
};

/// An edge's own view: by the middles of the stretches between the silhouettes that pass over it.
Sight sightOf(const ProjectedHalf& half, const FaceGrid& grid, const ShadowEdge& edge,
              std::vector<double> cuts) {
    Sight sight;
    cuts.push_back(0);
    cuts.push_back(1);
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double middle = (cuts[i] + cuts[i + 1]) / 2;
        const Eigen::Vector2d p = half.end(edge, 0) + middle * (half.end(edge, 1) - half.end(edge, 0));
        sight.seen.push_back(grid.coveredAt(p, mix(edge.height, middle), edge.face) ? 0 : 1);
    }
    sight.cuts = std::move(cuts);
    return sight;
}

bool seenAt(const Sight& sight, double t) {
    const auto after = std::upper_bound(sight.cuts.begin(), sight.cuts.end() - 1, t);
    const auto stretch = std::max<std::ptrdiff_t>(after - sight.cuts.begin() - 1, 0);
    return sight.seen[static_cast<std::size_t>(
               std::min<std::ptrdiff_t>(stretch, static_cast<std::ptrdiff_t>(sight.seen.size()) - 1))] != 0;
}

/// Whether what is seen of an edge changes at the cut t.
bool changesAt(const Sight& sight, double t) {
    const auto [from, to] = std::equal_range(sight.cuts.begin(), sight.cuts.end(), t);
    const auto before = static_cast<std::size_t>(from - sight.cuts.begin()) - 1;
    const auto after = static_cast<std::size_t>(to - sight.cuts.begin()) - 1;
    return sight.seen[before] != sight.seen[after];
}

/// Gives new points of the grid numbers after those of the half.
class Nodes {
public:
    explicit Nodes(const ProjectedHalf& half) : m_nodes(half.nodes) {
        for (std::size_t n = 0; n < m_nodes.size(); ++n)
            m_numbers.emplace(key(m_nodes[n]), static_cast<int>(n));
    }

    int at(const Eigen::Vector2d& p) {
        const auto [place, fresh] = m_numbers.emplace(key(p), static_cast<int>(m_nodes.size()));
        if (fresh)
            m_nodes.push_back(p);
        return place->second;
    }

    std::vector<Eigen::Vector2d> take() { return std::move(m_nodes); }

private:
    static std::int64_t key(const Eigen::Vector2d& p) {
        return static_cast<std::int64_t>(p.x()) * (std::int64_t{1} << 32) + static_cast<std::int64_t>(p.y());
    }

    std::vector<Eigen::Vector2d> m_nodes;
    std::unordered_map<std::int64_t, int> m_numbers;
};

std::vector<Sight> allSights(const ProjectedHalf& half, const FaceGrid& grid,
                             const std::vector<Passing>& passings) {
    std::vector<std::vector<double>> cuts(half.edges.size());
    for (const Passing& passing : passings)
        cuts[static_cast<std::size_t>(passing.under)].push_back(passing.tUnder);
    std::vector<Sight> sights(half.edges.size());
    parallelFor(half.edges.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e)
            sights[e] = sightOf(half, grid, half.edges[e], std::move(cuts[e]));
    });
    return sights;
}

/// A node along an edge.
struct Mark {
    double t = 0;
    int node = 0;
};

/// Puts a node wherever an edge comes into sight or vanishes, on it and on what hides it.
std::vector<std::vector<Mark>> markEdges(const ProjectedHalf& half, const std::vector<Passing>& passings,
                                         const std::vector<Sight>& sights, VisibleEdges& result) {
    Nodes nodes(half);
    std::vector<std::vector<Mark>> marks(half.edges.size());
    for (std::size_t e = 0; e < half.edges.size(); ++e)
        marks[e] = {{0, half.edges[e].node[0]}, {1, half.edges[e].node[1]}};
    for (const Passing& passing : passings) {
        const auto under = static_cast<std::size_t>(passing.under);
        if (!changesAt(sights[under], passing.tUnder))
            continue;
        const ShadowEdge& edge = half.edges[under];
        const Eigen::Vector2d p =
            half.end(edge, 0) + passing.tUnder * (half.end(edge, 1) - half.end(edge, 0));
        const int node = nodes.at(p.array().round());
        marks[under].push_back({passing.tUnder, node});
        marks[static_cast<std::size_t>(passing.over)].push_back({passing.tOver, node});
        if (node >= static_cast<int>(half.nodes.size())) {
            result.nodeOnEdge.emplace_back(node, passing.under);
            result.nodeOnEdge.emplace_back(node, passing.over);
        }
    }
    std::sort(result.nodeOnEdge.begin(), result.nodeOnEdge.end());
    result.nodes = nodes.take();
    return marks;
}

} // namespace

VisibleEdges findVisibleEdges(const ProjectedHalf& half, const FaceGrid& grid) {
    const std::vector<Passing> passings = findPassings(half);
    const std::vector<Sight> sights = allSights(half, grid, passings);
    VisibleEdges result;
    std::vector<std::vector<Mark>> marks = markEdges(half, passings, sights, result);
    for (std::size_t e = 0; e < half.edges.size(); ++e) {
        std::stable_sort(marks[e].begin(), marks[e].end(),
                         [](const Mark& a, const Mark& b) { return a.t < b.t; });
        for (std::size_t i = 0; i + 1 < marks[e].size(); ++i) {
            const Mark& from = marks[e][i];
            const Mark& to = marks[e][i + 1];
            if (from.node != to.node && seenAt(sights[e], (from.t + to.t) / 2))
                result.segments.push_back({from.node, to.node});
        }
    }
    return result;
}

} // namespace moldwright

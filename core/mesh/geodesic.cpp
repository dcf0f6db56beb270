// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geodesic.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>

namespace moldwright {

namespace {

constexpr int kSources = 20; ///< that the mean distance is taken to
constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kAlike = 1e-9; ///< share by which lengths differ by rounding alone: then the index decides,
                                ///< so that a turned part has its tips in the same places

/// Mean distance to points spread over the surface, each the farthest from those before it.
std::vector<double> meanDistance(const EdgeGraph& graph) {
    std::vector<double> mean(static_cast<std::size_t>(graph.size()), 0);
    std::vector<double> nearest(mean.size(), kFar);
    int source = 0;
    for (int i = 0; i < std::min(kSources, graph.size()); ++i) {
        const std::vector<double> distance = graph.distances({source});
        double farthest = 0;
        source = 0;
        for (std::size_t v = 0; v < mean.size(); ++v) {
            if (distance[v] < kFar)
                mean[v] += distance[v] / kSources;
            nearest[v] = std::min(nearest[v], distance[v]);
            if (nearest[v] < kFar && nearest[v] > farthest * (1 + kAlike)) {
                farthest = nearest[v];
                source = static_cast<int>(v);
            }
        }
    }
    return mean;
}

} // namespace

EdgeGraph::EdgeGraph(const IndexedMesh& mesh)
    : m_neighbours(static_cast<std::size_t>(mesh.vertexCount())), m_lengths(m_neighbours.size()) {
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k) {
            // In a closed mesh each edge is met once a direction.
            const int a = mesh.F(f, k);
            const int b = mesh.F(f, (k + 1) % 3);
            m_neighbours[static_cast<std::size_t>(a)].push_back(b);
            m_lengths[static_cast<std::size_t>(a)].push_back((mesh.point(a) - mesh.point(b)).norm());
        }
}

std::vector<double> EdgeGraph::distances(const std::vector<int>& sources) const {
    using Entry = std::pair<double, int>;
    std::vector<double> distance(m_neighbours.size(), kFar);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const int s : sources) {
        distance[static_cast<std::size_t>(s)] = 0;
        queue.emplace(0, s);
    }
    while (!queue.empty()) {
        const auto [d, v] = queue.top();
        queue.pop();
        if (d > distance[static_cast<std::size_t>(v)])
            continue;
        const auto& around = m_neighbours[static_cast<std::size_t>(v)];
        for (std::size_t i = 0; i < around.size(); ++i) {
            const double through = d + m_lengths[static_cast<std::size_t>(v)][i];
            if (through < distance[static_cast<std::size_t>(around[i])]) {
                distance[static_cast<std::size_t>(around[i])] = through;
                queue.emplace(through, around[i]);
            }
        }
    }
    return distance;
}

std::vector<int> limbTips(const EdgeGraph& graph, double prominence) {
    std::vector<double> height = meanDistance(graph);
    const double step = kAlike * *std::max_element(height.begin(), height.end());
    if (step > 0)
        for (double& h : height)
            h = step * std::round(h / step);
    std::vector<int> order(height.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return height[static_cast<std::size_t>(a)] > height[static_cast<std::size_t>(b)];
    });
    // Flooding from above: each peak owns a basin until it meets a higher one at a saddle; its prominence is
    // the fall between.
    std::vector<int> basin(height.size(), -1);
    std::vector<int> parent;
    std::vector<int> peak;
    std::vector<double> fall;
    const auto root = [&](int b) {
        while (parent[static_cast<std::size_t>(b)] != b)
            b = parent[static_cast<std::size_t>(b)];
        return b;
    };
    for (const int v : order) {
        int mine = -1;
        for (const int w : graph.neighbours(v)) {
            if (basin[static_cast<std::size_t>(w)] < 0)
                continue;
            const int other = root(basin[static_cast<std::size_t>(w)]);
            if (mine < 0 || other == mine) {
                mine = other;
                continue;
            }
            const int lower = std::max(mine, other); // later founded, so its peak is lower
            const int higher = std::min(mine, other);
            fall[static_cast<std::size_t>(lower)] =
                height[static_cast<std::size_t>(peak[static_cast<std::size_t>(lower)])] -
                height[static_cast<std::size_t>(v)];
            parent[static_cast<std::size_t>(lower)] = higher;
            mine = higher;
        }
        if (mine < 0) {
            mine = static_cast<int>(peak.size());
            peak.push_back(v);
            parent.push_back(mine);
            fall.push_back(kFar);
        }
        basin[static_cast<std::size_t>(v)] = mine;
    }
    std::vector<int> chosen(peak.size());
    std::iota(chosen.begin(), chosen.end(), 0);
    std::erase_if(chosen, [&](int b) { return fall[static_cast<std::size_t>(b)] < prominence; });
    std::stable_sort(chosen.begin(), chosen.end(), [&](int a, int b) {
        return fall[static_cast<std::size_t>(a)] > fall[static_cast<std::size_t>(b)];
    });
    for (int& b : chosen)
        b = peak[static_cast<std::size_t>(b)];
    return chosen;
}

} // namespace moldwright

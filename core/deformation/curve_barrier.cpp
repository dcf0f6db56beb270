// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/curve_barrier.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace moldwright {

namespace {

constexpr double kKeptShare = 0.2; ///< of each distance on one step
constexpr int kAdvances = 40;      ///< of the conservative advancement

Eigen::Vector2d at(const Positions& X, int v) {
    return X.row(v).head<2>().transpose();
}

} // namespace

SegmentDistance segmentDistance(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                                const Eigen::Vector2d& b) {
    const Eigen::Vector2d ab = b - a;
    const double square = ab.squaredNorm();
    const double t = square > 0 ? std::clamp((p - a).dot(ab) / square, 0.0, 1.0) : 0.0;
    return {(p - a - t * ab).norm(), t};
}

CurveBarrier::CurveBarrier(std::vector<std::array<int, 2>> edges, const Positions& X)
    : m_edges(std::move(edges)) {
    if (m_edges.empty())
        return;
    m_clearance.assign(static_cast<std::size_t>(X.rows()), 0);
    for (const auto& [a, b] : m_edges) {
        m_points.push_back(a);
        m_points.push_back(b);
        m_meanEdge += (at(X, a) - at(X, b)).norm() / static_cast<double>(m_edges.size());
    }
    std::sort(m_points.begin(), m_points.end());
    m_points.erase(std::unique(m_points.begin(), m_points.end()), m_points.end());
    for (const int p : m_points)
        m_clearance[static_cast<std::size_t>(p)] = m_meanEdge;
    for (const Pair& pair : pairsWithin(X, nullptr, 0, m_meanEdge)) {
        const auto& [a, b] = m_edges[static_cast<std::size_t>(pair.edge)];
        double& clearance = m_clearance[static_cast<std::size_t>(pair.point)];
        clearance = std::min(clearance, segmentDistance(at(X, pair.point), at(X, a), at(X, b)).distance);
    }
}

double CurveBarrier::reachOf(const Pair& pair) const {
    const auto& [a, b] = m_edges[static_cast<std::size_t>(pair.edge)];
    const double clearance =
        std::min({m_clearance[static_cast<std::size_t>(pair.point)], m_clearance[static_cast<std::size_t>(a)],
                  m_clearance[static_cast<std::size_t>(b)]});
    return std::clamp(0.5 * clearance, 0.02 * m_meanEdge, 0.5 * m_meanEdge);
}

/// Pairs whose boxes, swept from X to X + step·D, come within `reach`: a sweep along x.
std::vector<CurveBarrier::Pair> CurveBarrier::pairsWithin(const Positions& X, const Positions* D, double step,
                                                          double reach) const {
    struct Box {
        Eigen::Vector2d low, high;
    };
    const auto grow = [&](Box& box, int v) {
        box.low = box.low.cwiseMin(at(X, v));
        box.high = box.high.cwiseMax(at(X, v));
        if (D) {
            const Eigen::Vector2d end = at(X, v) + step * at(*D, v);
            box.low = box.low.cwiseMin(end);
            box.high = box.high.cwiseMax(end);
        }
    };
    const double far = std::numeric_limits<double>::infinity();
    const Box empty{{far, far}, {-far, -far}};
    std::vector<Box> pointBox(m_points.size(), empty);
    std::vector<Box> edgeBox(m_edges.size(), empty);
    for (std::size_t i = 0; i < m_points.size(); ++i)
        grow(pointBox[i], m_points[i]);
    for (std::size_t e = 0; e < m_edges.size(); ++e) {
        grow(edgeBox[e], m_edges[e][0]);
        grow(edgeBox[e], m_edges[e][1]);
        edgeBox[e].low.array() -= reach;
        edgeBox[e].high.array() += reach;
    }
    const auto byLow = [](const std::vector<Box>& boxes) {
        std::vector<int> order(boxes.size());
        std::iota(order.begin(), order.end(), 0);
        std::sort(order.begin(), order.end(), [&](int a, int b) {
            const double xa = boxes[static_cast<std::size_t>(a)].low.x();
            const double xb = boxes[static_cast<std::size_t>(b)].low.x();
            return xa != xb ? xa < xb : a < b;
        });
        return order;
    };
    const std::vector<int> points = byLow(pointBox);
    const std::vector<int> edges = byLow(edgeBox);
    std::vector<Pair> pairs;
    std::vector<int> activePoints;
    std::vector<int> activeEdges;
    const auto test = [&](int i, int e) {
        const Box& p = pointBox[static_cast<std::size_t>(i)];
        const Box& s = edgeBox[static_cast<std::size_t>(e)];
        const int point = m_points[static_cast<std::size_t>(i)];
        const auto& [a, b] = m_edges[static_cast<std::size_t>(e)];
        if (point != a && point != b && p.low.y() <= s.high.y() && s.low.y() <= p.high.y())
            pairs.push_back({point, e});
    };
    std::size_t i = 0;
    std::size_t e = 0;
    while (i < points.size() || e < edges.size()) {
        const double xp = i < points.size() ? pointBox[static_cast<std::size_t>(points[i])].low.x() : far;
        const double xe = e < edges.size() ? edgeBox[static_cast<std::size_t>(edges[e])].low.x() : far;
        if (xp < xe) {
            std::erase_if(activeEdges,
                          [&](int k) { return edgeBox[static_cast<std::size_t>(k)].high.x() < xp; });
            for (const int k : activeEdges)
                test(points[i], k);
            activePoints.push_back(points[i++]);
        } else {
            std::erase_if(activePoints,
                          [&](int k) { return pointBox[static_cast<std::size_t>(k)].high.x() < xe; });
            for (const int k : activePoints)
                test(k, edges[e]);
            activeEdges.push_back(edges[e++]);
        }
    }
    return pairs;
}

double CurveBarrier::energy(const Positions& X, double factor, Positions& gradient) const {
    if (m_edges.empty())
        return 0;
    double sum = 0;
    for (const Pair& pair : pairsWithin(X, nullptr, 0, 0.5 * m_meanEdge)) {
        const auto& [a, b] = m_edges[static_cast<std::size_t>(pair.edge)];
        const Eigen::Vector2d p = at(X, pair.point);
        const auto [distance, t] = segmentDistance(p, at(X, a), at(X, b));
        const double reach = reachOf(pair);
        if (distance >= reach)
            continue;
        if (!(distance > 0))
            return std::numeric_limits<double>::infinity();
        const double s = distance / reach;
        const double scale = reach * m_meanEdge;
        sum -= scale * (1 - s) * (1 - s) * std::log(s);
        const double slope = scale / reach * (2 * (1 - s) * std::log(s) - (1 - s) * (1 - s) / s);
        const Eigen::Vector2d away = (p - ((1 - t) * at(X, a) + t * at(X, b))) / distance;
        const Eigen::RowVector2d push = factor * slope * away.transpose();
        gradient.row(pair.point).head<2>() += push;
        gradient.row(a).head<2>() -= (1 - t) * push;
        gradient.row(b).head<2>() -= t * push;
    }
    return sum;
}

double CurveBarrier::largestStep(const Positions& X, const Positions& D, double step) const {
    if (m_edges.empty())
        return step;
    for (const Pair& pair : pairsWithin(X, &D, step, 0)) {
        const auto& [a, b] = m_edges[static_cast<std::size_t>(pair.edge)];
        // Relative to their mean motion: things that move together do not approach.
        const Eigen::Vector2d mean = (at(D, pair.point) + at(D, a) + at(D, b)) / 3;
        const Eigen::Vector2d dp = at(D, pair.point) - mean;
        const Eigen::Vector2d da = at(D, a) - mean;
        const Eigen::Vector2d db = at(D, b) - mean;
        const double speed = dp.norm() + std::max(da.norm(), db.norm());
        const auto distanceAt = [&](double s) {
            return segmentDistance(at(X, pair.point) + s * dp, at(X, a) + s * da, at(X, b) + s * db).distance;
        };
        const double kept = kKeptShare * distanceAt(0);
        double s = 0;
        for (int i = 0; i < kAdvances && s < step; ++i) {
            const double gap = distanceAt(s) - kept;
            if (!(gap > 1e-3 * kept))
                break;
            s += gap / std::max(speed, 1e-300);
        }
        step = std::min(step, s);
    }
    return step;
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/outlines.h"

#include "fill/projected_half.h"
#include "mesh/touching_boxes.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

namespace moldwright {

namespace {

using Vertex = HeightField::Vertex;
using Place = std::pair<double, double>;

constexpr int kRounds = 6;

Place placeOf(const HeightField& field, Vertex v) {
    return {field.point(v).x(), field.point(v).y()};
}

/// The points of one half's outline by their coordinates.
std::map<Place, Vertex> outlinePoints(const std::array<HeightField, 2>& halves, std::size_t half) {
    std::map<Place, Vertex> points;
    for (const OutlineEdge& edge : outlinesOf(halves))
        if (edge.half == half)
            points.emplace(placeOf(halves[half], edge.from), edge.from);
    for (const OutlineEdge& edge : outlinesOf(halves))
        if (edge.half == half)
            points.emplace(placeOf(halves[half], edge.to), edge.to);
    return points;
}

/// A point of one outline and an edge of the other that comes near it.
struct Touch {
    Vertex point;
    OutlineEdge edge;
};

/// Nearest first.
std::vector<Touch> findTouches(const std::array<HeightField, 2>& halves, std::size_t half, double near) {
    const std::map<Place, Vertex> points = outlinePoints(halves, half);
    std::vector<OutlineEdge> edges = outlinesOf(halves);
    std::erase_if(edges, [&](const OutlineEdge& edge) { return edge.half == half; });
    std::vector<Vertex> candidates;
    candidates.reserve(points.size());
    IndexedMesh boxes; // points as small triangles, edges as flat ones: what the tree of boxes takes
    boxes.V = Points::Zero(static_cast<Eigen::Index>(2 * points.size() + 2 * edges.size()), 3);
    boxes.F.resize(static_cast<Eigen::Index>(points.size() + edges.size()), 3);
    Eigen::Index row = 0;
    const auto add = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        boxes.V.row(2 * row).head<2>() = a.transpose();
        boxes.V.row(2 * row + 1).head<2>() = b.transpose();
        boxes.F.row(row) << static_cast<int>(2 * row), static_cast<int>(2 * row + 1),
            static_cast<int>(2 * row + 1);
        ++row;
    };
    for (const auto& [place, v] : points) {
        const Eigen::Vector2d p = halves[half].point(v);
        add(p.array() - near, p.array() + near);
        candidates.push_back(v);
    }
    for (const OutlineEdge& edge : edges)
        add(halves[edge.half].point(edge.from), halves[edge.half].point(edge.to));
    std::vector<int> all(static_cast<std::size_t>(row));
    std::iota(all.begin(), all.end(), 0);
    const int count = static_cast<int>(candidates.size());
    std::vector<Touch> touches;
    for (const auto& [i, j] :
         pairsWithTouchingBoxes(boxes, all, [&](int f, int g) { return f < count && g >= count; }))
        touches.push_back(
            {candidates[static_cast<std::size_t>(i)], edges[static_cast<std::size_t>(j - count)]});
    return touches;
}

class Matching {
public:
    Matching(std::array<HeightField, 2>& halves, std::size_t half, double near)
        : m_own(halves[half]), m_other(halves[1 - half]), m_near(near),
          m_ownPoints(outlinePoints(halves, half)), m_otherPoints(outlinePoints(halves, 1 - half)) {}

    bool settle(const Touch& touch) {
        if (m_otherPoints.contains(placeOf(m_own, touch.point)))
            return false;
        for (const Vertex end : {touch.edge.from, touch.edge.to})
            if ((m_other.point(end) - m_own.point(touch.point)).norm() <= m_near && join(touch.point, end))
                return true;
        return putOn(touch.point, touch.edge);
    }

private:
    /// Makes two near points of both outlines one.
    bool join(Vertex own, Vertex other) {
        if (m_ownPoints.contains(placeOf(m_other, other)))
            return false;
        return moveTo(m_own, m_ownPoints, own, m_other.point(other)) ||
               moveTo(m_other, m_otherPoints, other, m_own.point(own));
    }

    static bool moveTo(HeightField& field, std::map<Place, Vertex>& points, Vertex v,
                       const Eigen::Vector2d& p) {
        const Eigen::Vector2d before = field.point(v);
        field.move(v, p);
        const auto fan = field.fan(v);
        if (!std::all_of(fan.begin(), fan.end(), [&](auto f) { return field.area(f) > 0; })) {
            field.move(v, before);
            return false;
        }
        points.erase({before.x(), before.y()});
        points.emplace(Place{p.x(), p.y()}, v);
        return true;
    }

    bool putOn(Vertex v, const OutlineEdge& edge) {
        const auto h = m_other.mesh().find_halfedge(edge.from, edge.to);
        if (!h.is_valid())
            return false;
        const Eigen::Vector2d p = m_own.point(v);
        const Eigen::Vector2d a = m_other.point(edge.from);
        const Eigen::Vector2d along = m_other.point(edge.to) - a;
        const double t = (p - a).dot(along) / along.squaredNorm();
        const double off = std::abs(doubleArea(a, m_other.point(edge.to), p)) / along.norm();
        if (!(t > 0 && t < 1) || off > m_near || !m_other.splitKeepsOrder(m_other.mesh().edge_handle(h), p))
            return false;
        const Vertex fresh = m_other.split(m_other.mesh().edge_handle(h), p);
        m_otherPoints.emplace(Place{p.x(), p.y()}, fresh);
        return true;
    }

    HeightField& m_own;
    HeightField& m_other;
    double m_near;
    std::map<Place, Vertex> m_ownPoints;
    std::map<Place, Vertex> m_otherPoints;
};

} // namespace

std::vector<OutlineEdge> outlinesOf(const std::array<HeightField, 2>& halves) {
    std::vector<OutlineEdge> outlines;
    for (std::size_t half = 0; half < 2; ++half) {
        const TriangleMesh& mesh = halves[half].mesh();
        for (const auto e : mesh.edges())
            if (halves[half].outline(e)) {
                const auto h = mesh.halfedge_handle(e, 0);
                outlines.push_back({half, mesh.from_vertex_handle(h), mesh.to_vertex_handle(h)});
            }
    }
    return outlines;
}

void matchOutlines(std::array<HeightField, 2>& halves, double near) {
    // What one match changes another may have waited for: an edge split in two, a point moved.
    for (int round = 0; round < kRounds; ++round) {
        bool changed = false;
        for (const std::size_t half : {std::size_t{0}, std::size_t{1}}) {
            Matching matching(halves, half, near);
            for (const Touch& touch : findTouches(halves, half, near))
                changed = matching.settle(touch) || changed;
        }
        if (!changed)
            return;
    }
}

} // namespace moldwright

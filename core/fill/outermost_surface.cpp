// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/outermost_surface.h"

#include "base/parallel.h"
#include "fill/cgal/planar_triangulation.h"
#include "fill/face_grid.h"
#include "fill/visible_edges.h"
#include "mesh/union_find.h"

#include <algorithm>

namespace moldwright {

namespace {

constexpr std::size_t kGrain = 256;
constexpr double kThinnest = 2;  ///< grid steps: of thinner triangles rounding decides what is seen
constexpr double kMargin = 1.25; ///< the frame about everything, in reaches
constexpr int kFrame = -1;       ///< the number of its corners

/// The triangulated plane and which node of VisibleEdges each point is.
struct Plane {
    PlanarTriangulation triangulation;
    std::vector<int> nodeOf;
};

Plane triangulate(const VisibleEdges& edges) {
    Plane plane;
    std::vector<int> number(edges.nodes.size(), -1);
    std::vector<Eigen::Vector2d> points;
    const double far = kMargin * ShadowGrid::reach;
    for (const auto& [x, y] : {std::pair{-far, -far}, {far, -far}, {far, far}, {-far, far}}) {
        points.emplace_back(x, y);
        plane.nodeOf.push_back(kFrame);
    }
    std::vector<std::array<int, 2>> segments = edges.segments;
    for (auto& segment : segments)
        for (int& node : segment) {
            int& known = number[static_cast<std::size_t>(node)];
            if (known < 0) {
                known = static_cast<int>(points.size());
                points.push_back(edges.nodes[static_cast<std::size_t>(node)]);
                plane.nodeOf.push_back(node);
            }
            node = known;
        }
    plane.triangulation = triangulatePlane(points, segments);
    plane.nodeOf.resize(plane.triangulation.points.size(), kFrame);
    return plane;
}

class Triangle {
public:
    Triangle(const PlanarTriangulation& plane, std::size_t t) {
        for (std::size_t k = 0; k < 3; ++k)
            m_corners[k] = plane.points[static_cast<std::size_t>(plane.triangles[t][k])];
    }

    [[nodiscard]] double area() const { return doubleArea(m_corners[0], m_corners[1], m_corners[2]); }
    [[nodiscard]] Eigen::Vector2d middle() const { return (m_corners[0] + m_corners[1] + m_corners[2]) / 3; }
    [[nodiscard]] bool thin() const {
        const double longest =
            std::max({(m_corners[1] - m_corners[0]).norm(), (m_corners[2] - m_corners[1]).norm(),
                      (m_corners[0] - m_corners[2]).norm()});
        return area() < kThinnest * longest;
    }

private:
    std::array<Eigen::Vector2d, 3> m_corners;
};

/// The face seen in each triangle. Thin ones see what the largest triangle sees that no line parts them from.
std::vector<int> facesSeen(const PlanarTriangulation& plane, const FaceGrid& grid) {
    const std::size_t count = plane.triangles.size();
    std::vector<int> seen(count, -1);
    parallelFor(count, kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t)
            seen[t] = grid.topAt(Triangle(plane, t).middle());
    });
    UnionFind regions(static_cast<int>(count));
    for (std::size_t t = 0; t < count; ++t)
        for (std::size_t k = 0; k < 3; ++k)
            if (const int neighbour = plane.neighbours[t][k]; neighbour >= 0 && plane.onSegment[t][k] == 0)
                regions.unite(static_cast<int>(t), neighbour);
    std::vector<int> largest(count, -1);
    for (std::size_t t = 0; t < count; ++t) {
        int& best = largest[static_cast<std::size_t>(regions.rootOf(static_cast<int>(t)))];
        if (best < 0 || Triangle(plane, t).area() > Triangle(plane, static_cast<std::size_t>(best)).area())
            best = static_cast<int>(t);
    }
    for (std::size_t t = 0; t < count; ++t)
        if (Triangle(plane, t).thin())
            seen[t] = seen[static_cast<std::size_t>(
                largest[static_cast<std::size_t>(regions.rootOf(static_cast<int>(t)))])];
    return seen;
}

/// Height of a face at a node: its own corner's; along the edge that the node lies on, so that both faces
/// there agree; else its plane's.
double heightAtNode(const ProjectedHalf& half, const VisibleEdges& edges, int face, int node,
                    const Eigen::Vector2d& p) {
    const ShadowFace& seen = half.faces[static_cast<std::size_t>(face)];
    for (std::size_t k = 0; k < 3; ++k)
        if (seen.node[k] == node)
            return seen.height[k];
    auto at = std::lower_bound(edges.nodeOnEdge.begin(), edges.nodeOnEdge.end(), std::pair{node, -1});
    for (; node >= 0 && at != edges.nodeOnEdge.end() && at->first == node; ++at) {
        const ShadowEdge& edge = half.edges[static_cast<std::size_t>(at->second)];
        if (edge.face[0] != face && edge.face[1] != face)
            continue;
        const Eigen::Vector2d along = half.end(edge, 1) - half.end(edge, 0);
        const double t = std::clamp((p - half.end(edge, 0)).dot(along) / along.squaredNorm(), 0.0, 1.0);
        return edge.height[0] + t * (edge.height[1] - edge.height[0]);
    }
    return heightAt(half, seen, p);
}

/// The frame stays, and so does the parting line, which is shared with the other half.
void setOrigins(HeightField& field, const ProjectedHalf& half, const Plane& plane) {
    for (const auto v : field.mesh().vertices()) {
        const int node = plane.nodeOf[static_cast<std::size_t>(v.idx())];
        if (field.mesh().is_boundary(v) || (node >= 0 && node < static_cast<int>(half.nodes.size()) &&
                                            half.inPlane[static_cast<std::size_t>(node)]))
            field.setOrigin(v, HeightField::Origin::Fixed);
        else if (node >= 0 && node < static_cast<int>(half.nodes.size()))
            field.setOrigin(v, HeightField::Origin::Part);
    }
}

/// Heights at a point that nearly agree become one: the highest of them, or 0 with the plane among them.
void joinNearHeights(HeightField& field, double step) {
    std::vector<HeightField::Halfedge> corners;
    for (const auto v : field.mesh().vertices()) {
        corners.clear();
        for (const auto h : field.mesh().vih_range(v))
            if (!field.mesh().is_boundary(h))
                corners.push_back(h);
        std::stable_sort(corners.begin(), corners.end(),
                         [&](auto a, auto b) { return field.height(a) > field.height(b); });
        for (std::size_t i = 0; i < corners.size();) {
            std::size_t end = i + 1;
            while (end < corners.size() &&
                   field.height(corners[end - 1]) - field.height(corners[end]) <= step)
                ++end;
            const double level = field.height(corners[end - 1]) <= step ? 0 : field.height(corners[i]);
            for (; i < end; ++i)
                field.setHeight(corners[i], level);
        }
    }
}

} // namespace

HeightField outermostSurface(const ProjectedHalf& half, double step, const Task& task) {
    const FaceGrid grid(half);
    const VisibleEdges edges = task.stopped() ? VisibleEdges{} : findVisibleEdges(half, grid);
    const Plane plane = task.stopped() ? Plane{} : triangulate(edges);
    const std::vector<int> seen = facesSeen(plane.triangulation, grid);
    HeightField field(plane.triangulation.points, plane.triangulation.triangles);
    for (const auto f : field.mesh().faces()) {
        const int face = seen[static_cast<std::size_t>(f.idx())];
        if (face < 0)
            continue;
        field.setSeen(f, half.faces[static_cast<std::size_t>(face)].source);
        for (const auto h : field.mesh().fh_range(f)) {
            const auto v = field.mesh().to_vertex_handle(h);
            field.setHeight(h, heightAtNode(half, edges, face,
                                            plane.nodeOf[static_cast<std::size_t>(v.idx())], field.point(v)));
        }
    }
    setOrigins(field, half, plane);
    joinNearHeights(field, step);
    return field;
}

} // namespace moldwright

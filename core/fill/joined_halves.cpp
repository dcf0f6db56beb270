// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/joined_halves.h"

#include "fill/cgal/planar_triangulation.h"
#include "fill/outlines.h"
#include "mesh/point_rows.h"

#include <algorithm>
#include <map>
#include <queue>
#include <set>

namespace moldwright {

namespace {

using Vertex = HeightField::Vertex;
using Face = HeightField::Face;

/// The points of the plane by their exact coordinates.
class PlanePoints {
public:
    int at(const Eigen::Vector2d& p) {
        const auto [place, fresh] =
            m_numbers.emplace(std::pair{p.x(), p.y()}, static_cast<int>(m_points.size()));
        if (fresh)
            m_points.push_back(p);
        return place->second;
    }

    [[nodiscard]] const std::vector<Eigen::Vector2d>& points() const { return m_points; }

private:
    std::map<std::pair<double, double>, int> m_numbers;
    std::vector<Eigen::Vector2d> m_points;
};

/// A triangle of the plane and in which halves' outlines it lies.
struct Cap {
    std::array<int, 3> corners{};
    std::array<char, 2> inside{};
};

using EdgeSet = std::set<std::pair<int, int>>;

/// Floods the plane from outside; every outline crossed changes what one lies in.
std::vector<Cap> capsBetween(const PlanarTriangulation& plane, const std::array<EdgeSet, 2>& outlines) {
    const std::size_t count = plane.triangles.size();
    std::vector<Cap> caps(count);
    std::vector<char> reached(count, 0);
    std::queue<std::size_t> open;
    const auto enter = [&](std::size_t t, std::size_t k, std::array<char, 2> inside) {
        if (reached[t])
            return;
        const auto edge = std::minmax(plane.triangles[t][k], plane.triangles[t][(k + 1) % 3]);
        for (std::size_t half = 0; half < 2; ++half)
            if (outlines[half].contains(edge))
                inside[half] = inside[half] ? 0 : 1;
        caps[t] = {plane.triangles[t], inside};
        reached[t] = 1;
        open.push(t);
    };
    for (std::size_t t = 0; t < count; ++t)
        for (std::size_t k = 0; k < 3; ++k)
            if (plane.neighbours[t][k] < 0)
                enter(t, k, {0, 0});
    for (; !open.empty(); open.pop()) {
        const std::size_t t = open.front();
        for (std::size_t k = 0; k < 3; ++k) {
            if (plane.neighbours[t][k] < 0)
                continue;
            const auto next = static_cast<std::size_t>(plane.neighbours[t][k]);
            const auto shared =
                std::find(plane.neighbours[next].begin(), plane.neighbours[next].end(), static_cast<int>(t)) -
                plane.neighbours[next].begin();
            enter(next, static_cast<std::size_t>(shared), caps[t].inside);
        }
    }
    return caps;
}

/// Puts onto the outlines the points where they cross each other; the parts of the plane between them.
std::vector<Cap> crossOutlines(std::array<HeightField, 2>& halves, PlanePoints& points) {
    const std::vector<OutlineEdge> outlines = outlinesOf(halves);
    std::vector<std::array<int, 2>> segments;
    segments.reserve(outlines.size());
    for (const OutlineEdge& edge : outlines)
        segments.push_back(
            {points.at(halves[edge.half].point(edge.from)), points.at(halves[edge.half].point(edge.to))});
    if (segments.empty())
        return {};
    CrossedSegments crossed = crossSegments(points.points(), segments);
    const PlanarTriangulation& plane = crossed.triangulation;
    std::array<EdgeSet, 2> edges;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        std::vector<int>& chain = crossed.chains[i];
        if (chain.front() != segments[i][0])
            std::reverse(chain.begin(), chain.end());
        HeightField& field = halves[outlines[i].half];
        Vertex from = outlines[i].from;
        for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
            edges[outlines[i].half].insert(std::minmax(chain[k], chain[k + 1]));
            if (k == 0)
                continue;
            const auto h = field.mesh().find_halfedge(from, outlines[i].to);
            from = field.split(field.mesh().edge_handle(h), plane.points[static_cast<std::size_t>(chain[k])]);
        }
    }
    for (const Eigen::Vector2d& p : plane.points)
        points.at(p);
    return capsBetween(plane, edges);
}

/// Collects the faces of the result; points are told apart by where they stand and how high.
class Body {
public:
    Body(const ShadowGrid& grid, PlanePoints& points) : m_grid(grid), m_ground(points) {}

    void addHalf(const HeightField& field, int side);
    void addCaps(const std::vector<Cap>& caps);
    [[nodiscard]] PartedMesh take() const;

private:
    /// The points above a vertex of a field, by height.
    using Column = std::map<double, int>;

    int pointAt(const HeightField& field, std::vector<Column>& columns, Vertex v, double height, int side);
    int groundPoint(int number);
    void addWall(const HeightField& field, std::vector<Column>& columns, HeightField::Edge e, int side);
    void addFace(std::array<int, 3> corners, int label, int source, bool turned);

    const ShadowGrid& m_grid;
    PlanePoints& m_ground;
    std::map<int, int> m_groundPoints;
    std::vector<Eigen::Vector3d> m_points;
    std::vector<std::array<int, 3>> m_faces;
    SideLabels m_labels;
    std::vector<int> m_sources;
};

int Body::groundPoint(int number) {
    const auto [place, fresh] = m_groundPoints.emplace(number, static_cast<int>(m_points.size()));
    if (fresh)
        m_points.push_back(m_grid.place(m_ground.points()[static_cast<std::size_t>(number)], 0, 1));
    return place->second;
}

int Body::pointAt(const HeightField& field, std::vector<Column>& columns, Vertex v, double height, int side) {
    if (height == 0)
        return groundPoint(m_ground.at(field.point(v)));
    const auto [place, fresh] =
        columns[static_cast<std::size_t>(v.idx())].emplace(height, static_cast<int>(m_points.size()));
    if (fresh)
        m_points.push_back(m_grid.place(field.point(v), height, side));
    return place->second;
}

void Body::addFace(std::array<int, 3> corners, int label, int source, bool turned) {
    if (turned)
        std::swap(corners[1], corners[2]);
    m_faces.push_back(corners);
    m_labels.push_back(static_cast<std::uint8_t>(label));
    m_sources.push_back(source);
}

void Body::addHalf(const HeightField& field, int side) {
    const TriangleMesh& mesh = field.mesh();
    std::vector<Column> columns(mesh.n_vertices());
    for (const auto f : mesh.faces()) {
        if (!field.solid(f))
            continue;
        std::array<int, 3> corners{};
        std::size_t k = 0;
        for (const auto h : mesh.fh_range(f))
            corners[k++] = pointAt(field, columns, mesh.to_vertex_handle(h), field.height(h), side);
        addFace(corners, side, field.seen(f), side == 2);
    }
    for (const auto e : mesh.edges())
        if (!mesh.is_boundary(e))
            addWall(field, columns, e, side);
}

/// The wall over an edge takes up every point of the columns at its ends, so that all that meets there
/// matches.
void Body::addWall(const HeightField& field, std::vector<Column>& columns, HeightField::Edge e, int side) {
    const TriangleMesh& mesh = field.mesh();
    const auto left = mesh.halfedge_handle(e, 0);
    const auto right = mesh.halfedge_handle(e, 1);
    const Vertex from = mesh.from_vertex_handle(left);
    const Vertex to = mesh.to_vertex_handle(left);
    const std::array<double, 2> atFrom = {field.height(mesh.prev_halfedge_handle(left)), field.height(right)};
    const std::array<double, 2> atTo = {field.height(left), field.height(mesh.prev_halfedge_handle(right))};
    const auto chain = [&](Vertex v, const std::array<double, 2>& heights) {
        const auto [low, high] = std::minmax(heights[0], heights[1]);
        std::vector<double> levels = {low};
        for (const auto h : mesh.vih_range(v))
            if (!mesh.is_boundary(h) && field.height(h) > low && field.height(h) <= high)
                levels.push_back(field.height(h));
        std::sort(levels.begin(), levels.end());
        levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
        return levels;
    };
    const std::vector<double> a = chain(from, atFrom);
    const std::vector<double> b = chain(to, atTo);
    // The left side is the higher one: the wall looks right.
    const bool leftHigher = atFrom[0] > atFrom[1] || atTo[0] > atTo[1];
    const bool turned = leftHigher == (side == 2);
    for (std::size_t i = 0, j = 0; i + 1 < a.size() || j + 1 < b.size();) {
        const bool stepFrom = j + 1 == b.size() || (i + 1 < a.size() && a[i + 1] < b[j + 1]);
        const int low = pointAt(field, columns, from, a[i], side);
        const int across = pointAt(field, columns, to, b[j], side);
        const int next = stepFrom ? pointAt(field, columns, from, a[i + 1], side)
                                  : pointAt(field, columns, to, b[j + 1], side);
        addFace({low, across, next}, side, -1, turned);
        ++(stepFrom ? i : j);
    }
}

void Body::addCaps(const std::vector<Cap>& caps) {
    for (const Cap& cap : caps) {
        if (cap.inside[0] == cap.inside[1])
            continue;
        // The half above rests on a face that looks down, and so belongs to side 2; and the other way round.
        const bool above = cap.inside[0] != 0;
        addFace({groundPoint(cap.corners[0]), groundPoint(cap.corners[1]), groundPoint(cap.corners[2])},
                above ? 2 : 1, -1, above);
    }
}

PartedMesh Body::take() const {
    PartedMesh result;
    result.mesh.V = pointRows(m_points);
    result.mesh.F.resize(static_cast<Eigen::Index>(m_faces.size()), 3);
    for (std::size_t f = 0; f < m_faces.size(); ++f)
        result.mesh.F.row(static_cast<Eigen::Index>(f)) << m_faces[f][0], m_faces[f][1], m_faces[f][2];
    result.labels = m_labels;
    result.sourceFace = m_sources;
    return result;
}

} // namespace

PartedMesh joinHalves(std::array<HeightField, 2>& halves, const ShadowGrid& grid) {
    PlanePoints points;
    const std::vector<Cap> caps = crossOutlines(halves, points);
    Body body(grid, points);
    body.addHalf(halves[0], 1);
    body.addHalf(halves[1], 2);
    body.addCaps(caps);
    return body.take();
}

} // namespace moldwright

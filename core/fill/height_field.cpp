// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/height_field.h"

#include "fill/projected_half.h"

#include <algorithm>

namespace moldwright {

namespace {

IndexedMesh flatMesh(const std::vector<Eigen::Vector2d>& points,
                     const std::vector<std::array<int, 3>>& triangles) {
    IndexedMesh mesh;
    mesh.V = Points::Zero(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t v = 0; v < points.size(); ++v)
        mesh.V.row(static_cast<Eigen::Index>(v)).head<2>() = points[v].transpose();
    mesh.F.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t f = 0; f < triangles.size(); ++f)
        mesh.F.row(static_cast<Eigen::Index>(f)) << triangles[f][0], triangles[f][1], triangles[f][2];
    return mesh;
}

} // namespace

HeightField::HeightField(const std::vector<Eigen::Vector2d>& points,
                         const std::vector<std::array<int, 3>>& triangles)
    : m_mesh(toTriangleMesh(flatMesh(points, triangles))) {
    m_mesh.add_property(m_height);
    m_mesh.add_property(m_seen);
    m_mesh.add_property(m_origin);
    for (const auto v : m_mesh.vertices())
        setOrigin(v, Origin::New);
    for (const auto h : m_mesh.halfedges())
        setHeight(h, 0);
    for (const auto f : m_mesh.faces())
        setSeen(f, -1);
}

HeightField::Halfedge HeightField::corner(Face f, Vertex v) const {
    Halfedge h = m_mesh.halfedge_handle(f);
    while (m_mesh.to_vertex_handle(h) != v)
        h = m_mesh.next_halfedge_handle(h);
    return h;
}

bool HeightField::solid(Face f) const {
    return f.is_valid() &&
           std::any_of(m_mesh.cfh_begin(f), m_mesh.cfh_end(f), [&](auto h) { return height(h) > 0; });
}

bool HeightField::outline(Edge e) const {
    return solid(m_mesh.face_handle(m_mesh.halfedge_handle(e, 0))) !=
           solid(m_mesh.face_handle(m_mesh.halfedge_handle(e, 1)));
}

double HeightField::area(Face f) const {
    const Halfedge h = m_mesh.halfedge_handle(f);
    return doubleArea(point(m_mesh.from_vertex_handle(h)), point(m_mesh.to_vertex_handle(h)),
                      point(m_mesh.to_vertex_handle(m_mesh.next_halfedge_handle(h))));
}

bool HeightField::splitKeepsOrder(Edge e, const Eigen::Vector2d& p) const {
    const Halfedge along = m_mesh.halfedge_handle(e, 0);
    const Eigen::Vector2d a = point(m_mesh.from_vertex_handle(along));
    const Eigen::Vector2d b = point(m_mesh.to_vertex_handle(along));
    const Eigen::Vector2d left = point(m_mesh.to_vertex_handle(m_mesh.next_halfedge_handle(along)));
    const Eigen::Vector2d right =
        point(m_mesh.to_vertex_handle(m_mesh.next_halfedge_handle(m_mesh.opposite_halfedge_handle(along))));
    return doubleArea(a, p, left) > 0 && doubleArea(p, b, left) > 0 && doubleArea(p, a, right) > 0 &&
           doubleArea(b, p, right) > 0;
}

HeightField::Vertex HeightField::split(Edge e, const Eigen::Vector2d& p) {
    // Per side of the edge: its far corner, and the heights of the triangle there.
    struct Side {
        Vertex far;
        double atFar = 0;
        double atFrom = 0;
        double atTo = 0;
        int seen = -1;
    };
    const Halfedge along = m_mesh.halfedge_handle(e, 0);
    const Vertex from = m_mesh.from_vertex_handle(along);
    const Vertex to = m_mesh.to_vertex_handle(along);
    std::array<Side, 2> sides;
    for (std::size_t k = 0; k < 2; ++k) {
        const Face f = m_mesh.face_handle(m_mesh.halfedge_handle(e, static_cast<unsigned>(k)));
        const Halfedge next =
            m_mesh.next_halfedge_handle(m_mesh.halfedge_handle(e, static_cast<unsigned>(k)));
        sides[k] = {m_mesh.to_vertex_handle(next), height(next), height(corner(f, from)),
                    height(corner(f, to)), seen(f)};
    }
    const double t = (p - point(from)).norm() / (point(to) - point(from)).norm();
    const Vertex v = m_mesh.add_vertex({p.x(), p.y(), 0});
    setOrigin(v, Origin::New);
    m_mesh.split(e, v);
    for (const auto f : m_mesh.vf_range(v)) {
        const Vertex far = sides[0].far;
        const bool first =
            std::any_of(m_mesh.cfv_begin(f), m_mesh.cfv_end(f), [&](auto w) { return w == far; });
        const Side& side = sides[first ? 0 : 1];
        setSeen(f, side.seen);
        for (const auto h : m_mesh.fh_range(f)) {
            const Vertex w = m_mesh.to_vertex_handle(h);
            setHeight(h, w == v          ? side.atFrom + t * (side.atTo - side.atFrom)
                         : w == side.far ? side.atFar
                         : w == from     ? side.atFrom
                                         : side.atTo);
        }
    }
    return v;
}

bool HeightField::wall(Edge e) const {
    if (m_mesh.is_boundary(e))
        return false;
    const Halfedge left = m_mesh.halfedge_handle(e, 0);
    const Halfedge right = m_mesh.halfedge_handle(e, 1);
    return height(left) != height(m_mesh.prev_halfedge_handle(right)) ||
           height(right) != height(m_mesh.prev_halfedge_handle(left)) || outline(e);
}

void HeightField::collapse(Halfedge h, const std::function<double(double)>& heightThere) {
    const Vertex gone = m_mesh.from_vertex_handle(h);
    const Halfedge back = m_mesh.opposite_halfedge_handle(h);
    for (const auto in : m_mesh.vih_range(gone))
        setHeight(in, heightThere(height(in)));
    // Collapsing a side away keeps the halfedge of its neighbour or its own: both lead to the same corner,
    // but in different triangles. What the neighbours hold is put back.
    std::vector<std::pair<Face, std::array<std::pair<Vertex, double>, 3>>> kept;
    const Face first = m_mesh.face_handle(h);
    const Face second = m_mesh.face_handle(back);
    const auto keep = [&](Face f) {
        if (!f.is_valid() || f == first || f == second)
            return;
        std::array<std::pair<Vertex, double>, 3> corners;
        std::size_t k = 0;
        for (const auto in : m_mesh.fh_range(f)) {
            const Vertex v = m_mesh.to_vertex_handle(in);
            corners[k++] = {v == gone ? m_mesh.to_vertex_handle(h) : v, height(in)};
        }
        kept.emplace_back(f, corners);
    };
    for (const Vertex v : {gone, m_mesh.to_vertex_handle(h)})
        for (const auto f : m_mesh.vf_range(v))
            keep(f);
    m_mesh.collapse(h);
    for (const auto& [f, corners] : kept)
        for (const auto& [v, z] : corners)
            setHeight(corner(f, v), z);
}

void HeightField::flip(Edge e, Face keep, bool extend) {
    const Halfedge along = m_mesh.halfedge_handle(e, 0);
    const Halfedge back = m_mesh.halfedge_handle(e, 1);
    const Face other =
        m_mesh.face_handle(along) == keep ? m_mesh.face_handle(back) : m_mesh.face_handle(along);
    const Vertex far = m_mesh.to_vertex_handle(
        m_mesh.next_halfedge_handle(m_mesh.face_handle(along) == other ? along : back));
    std::vector<std::pair<Vertex, double>> heights;
    for (const auto h : m_mesh.fh_range(keep))
        heights.emplace_back(m_mesh.to_vertex_handle(h), height(h));
    heights.emplace_back(far, extend ? planeAt(keep, point(far)) : height(corner(other, far)));
    const int face = seen(keep);
    m_mesh.flip(e);
    for (const Face f : {m_mesh.face_handle(along), m_mesh.face_handle(back)}) {
        setSeen(f, face);
        for (const auto h : m_mesh.fh_range(f))
            setHeight(h, std::find_if(heights.begin(), heights.end(), [&](const auto& known) {
                             return known.first == m_mesh.to_vertex_handle(h);
                         })->second);
    }
}

double HeightField::planeAt(Face f, const Eigen::Vector2d& p) const {
    std::array<Eigen::Vector2d, 3> x;
    std::array<double, 3> z{};
    std::size_t k = 0;
    for (const auto h : m_mesh.fh_range(f)) {
        x[k] = point(m_mesh.to_vertex_handle(h));
        z[k++] = height(h);
    }
    return (doubleArea(x[1], x[2], p) * z[0] + doubleArea(x[2], x[0], p) * z[1] +
            doubleArea(x[0], x[1], p) * z[2]) /
           doubleArea(x[0], x[1], x[2]);
}

std::vector<HeightField::Face> HeightField::fan(Vertex v) const {
    std::vector<Face> faces;
    for (auto it = m_mesh.cvf_ccwbegin(v); it != m_mesh.cvf_ccwend(v); ++it)
        faces.push_back(*it);
    return faces;
}

} // namespace moldwright

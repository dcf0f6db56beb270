// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/height_field.h"

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

HeightField::Vertex HeightField::split(Edge e, const Eigen::Vector2d& p) {
    // Per side of the edge: its far corner, and the heights of the triangle there.
    struct Side {
        Vertex far{};
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

std::vector<HeightField::Face> HeightField::fan(Vertex v) const {
    std::vector<Face> faces;
    for (auto it = m_mesh.cvf_ccwbegin(v); it != m_mesh.cvf_ccwend(v); ++it)
        faces.push_back(*it);
    return faces;
}

} // namespace moldwright

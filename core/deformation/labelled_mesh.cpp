// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/labelled_mesh.h"

#include "deformation/curve_barrier.h"

#include <algorithm>

namespace moldwright {

namespace {

using Point2 = Eigen::Vector2d;

/// Inside the triangle, or within `margin` of it. By distances: a point far along a straight curve is near
/// the lines of all three sides, not near the triangle.
bool nearTriangle(const Point2& q, const Point2& a, const Point2& b, const Point2& c, double margin) {
    const auto turn = [&](const Point2& s, const Point2& t) {
        return (t - s).x() * (q - s).y() - (t - s).y() * (q - s).x();
    };
    const double t0 = turn(a, b);
    const double t1 = turn(b, c);
    const double t2 = turn(c, a);
    const bool inside = (t0 > 0 && t1 > 0 && t2 > 0) || (t0 < 0 && t1 < 0 && t2 < 0);
    return inside || std::min({segmentDistance(q, a, b).distance, segmentDistance(q, b, c).distance,
                               segmentDistance(q, c, a).distance}) <= margin;
}

} // namespace

LabelledMesh::LabelledMesh(const LabelledSurface& surface) : m_mesh(toTriangleMesh(surface.mesh)) {
    m_mesh.add_property(m_label);
    for (const auto f : m_mesh.faces())
        m_mesh.property(m_label, f) = surface.labels[static_cast<std::size_t>(f.idx())];
    m_mesh.add_property(m_source);
    for (const auto v : m_mesh.vertices())
        m_mesh.property(m_source, v) = surface.sourceVertex[static_cast<std::size_t>(v.idx())];
    for (const auto v : m_mesh.vertices())
        if (onCurve(v))
            m_curvePoints.push_back(v);
}

LabelledSurface LabelledMesh::surface() {
    m_mesh.garbage_collection();
    LabelledSurface surface{toIndexedMesh(m_mesh), {}, {}};
    for (const auto f : m_mesh.faces())
        surface.labels.push_back(m_mesh.property(m_label, f));
    for (const auto v : m_mesh.vertices())
        surface.sourceVertex.push_back(m_mesh.property(m_source, v));
    return surface;
}

LabelledMesh::Corners LabelledMesh::corners(Face f) const {
    Corners x;
    std::size_t k = 0;
    for (const auto v : m_mesh.fv_range(f))
        x[k++] = m_mesh.point(v);
    return x;
}

bool LabelledMesh::onCurve(Edge e) const {
    return label(m_mesh.face_handle(m_mesh.halfedge_handle(e, 0))) !=
           label(m_mesh.face_handle(m_mesh.halfedge_handle(e, 1)));
}

bool LabelledMesh::onCurve(Vertex v) const {
    const auto edges = m_mesh.ve_range(v);
    return std::any_of(edges.begin(), edges.end(), [&](auto e) { return onCurve(e); });
}

bool LabelledMesh::mayFlip(Edge e) {
    if (onCurve(e) || !m_mesh.is_flip_ok(e))
        return false;
    const Halfedge h = m_mesh.halfedge_handle(e, 0);
    const Halfedge o = m_mesh.halfedge_handle(e, 1);
    const bool acrossInPlane = onPlane(m_mesh.to_vertex_handle(m_mesh.next_halfedge_handle(h))) &&
                               onPlane(m_mesh.to_vertex_handle(m_mesh.next_halfedge_handle(o)));
    return !(acrossInPlane && (onPlane(m_mesh.from_vertex_handle(h)) || onPlane(m_mesh.to_vertex_handle(h))));
}

bool LabelledMesh::mayCollapse(Halfedge h) {
    const bool along = onCurve(m_mesh.edge_handle(h));
    return (along || !onCurve(m_mesh.from_vertex_handle(h))) && m_mesh.is_collapse_ok(h) &&
           (!along || lineAllows(h));
}

void LabelledMesh::collapse(Halfedge h) {
    const bool along = onCurve(m_mesh.edge_handle(h));
    m_mesh.collapse(h);
    if (along)
        std::erase_if(m_curvePoints, [&](Vertex v) { return m_mesh.status(v).deleted(); });
}

/// Losing a point joins its neighbours on the line: p–gone–kept becomes p–kept. The line stays simple exactly
/// when no other of its points lies in that triangle.
bool LabelledMesh::lineAllows(Halfedge h) const {
    const Vertex gone = m_mesh.from_vertex_handle(h);
    const Vertex kept = m_mesh.to_vertex_handle(h);
    std::vector<Vertex> neighbours;
    for (const auto w : m_mesh.voh_range(gone))
        if (onCurve(m_mesh.edge_handle(w)))
            neighbours.push_back(m_mesh.to_vertex_handle(w));
    if (neighbours.size() != 2)
        return false;
    const Vertex p = neighbours[0] == kept ? neighbours[1] : neighbours[0];
    for (const auto w : m_mesh.voh_range(kept)) {
        const Vertex q = m_mesh.to_vertex_handle(w);
        if (q != gone && onCurve(m_mesh.edge_handle(w)) && loopIsShort(p, q))
            return false;
    }
    const auto at = [&](Vertex v) -> Point2 { return m_mesh.point(v).head<2>(); };
    const double margin = 0.01 * (at(gone) - at(kept)).norm();
    return std::none_of(m_curvePoints.begin(), m_curvePoints.end(), [&](Vertex v) {
        return v != p && v != gone && v != kept && nearTriangle(at(v), at(p), at(gone), at(kept), margin);
    });
}

/// After a collapse the loop would be p – kept – q: too short when p and q are joined by the line or the
/// same.
bool LabelledMesh::loopIsShort(Vertex p, Vertex q) const {
    if (p == q)
        return true;
    const Halfedge h = m_mesh.find_halfedge(p, q);
    return h.is_valid() && onCurve(m_mesh.edge_handle(h));
}

} // namespace moldwright

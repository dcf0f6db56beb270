// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/labelled_mesh.h"

#include "deformation/curve_barrier.h"

#include <algorithm>
#include <set>
#include <utility>

namespace moldwright {

namespace {

using Point2 = Eigen::Vector2d;

constexpr double kMargin = 0.01; ///< of the edge collapsed: what the line keeps from its other points
constexpr double kNearer = 0.9;  ///< of the distance now, where that is less

/// Strictly inside the triangle.
bool inTriangle(const Point2& q, const Point2& a, const Point2& b, const Point2& c) {
    const auto turn = [&](const Point2& s, const Point2& t) {
        return (t - s).x() * (q - s).y() - (t - s).y() * (q - s).x();
    };
    const double t0 = turn(a, b);
    const double t1 = turn(b, c);
    const double t2 = turn(c, a);
    return (t0 > 0 && t1 > 0 && t2 > 0) || (t0 < 0 && t1 < 0 && t2 < 0);
}

/// Whether the line comes to q, or nearer to it than `margin` and than it is now, where p–gone–kept becomes
/// p–kept. The two sides of a fin are near each other already: that must not keep it from being taken away.
bool sweepsOver(const Point2& q, const Point2& p, const Point2& gone, const Point2& kept, double margin) {
    const double now =
        std::min(segmentDistance(q, p, gone).distance, segmentDistance(q, gone, kept).distance);
    return inTriangle(q, p, gone, kept) ||
           segmentDistance(q, p, kept).distance <= std::min(margin, kNearer * now);
}

/// Of a part of a closed surface: whether its rim passes each point at most once.
bool rimIsSimple(const Triangles& F) {
    std::set<std::pair<int, int>> edges;
    for (Eigen::Index f = 0; f < F.rows(); ++f)
        for (int k = 0; k < 3; ++k)
            edges.emplace(F(f, k), F(f, (k + 1) % 3));
    std::set<int> left;
    return std::ranges::all_of(edges, [&](const auto& edge) {
        return edges.contains({edge.second, edge.first}) || left.insert(edge.first).second;
    });
}

} // namespace

int countFolds(const LabelledSurface& surface) {
    const IndexedMesh& mesh = surface.mesh;
    std::map<std::pair<int, int>, int> labelAt;
    int folds = 0;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        if (mesh.corner(f, 0).z() != 0 || mesh.corner(f, 1).z() != 0 || mesh.corner(f, 2).z() != 0)
            continue;
        const int label = surface.labels[static_cast<std::size_t>(f)];
        for (int k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(mesh.F(f, k), mesh.F(f, (k + 1) % 3));
            const auto [there, first] = labelAt.try_emplace({a, b}, label);
            folds += !first && there->second != label;
        }
    }
    return folds;
}

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
    return !m_mesh.is_boundary(e) && label(m_mesh.face_handle(m_mesh.halfedge_handle(e, 0))) !=
                                         label(m_mesh.face_handle(m_mesh.halfedge_handle(e, 1)));
}

bool LabelledMesh::onCurve(Vertex v) const {
    const auto edges = m_mesh.ve_range(v);
    return std::any_of(edges.begin(), edges.end(), [&](auto e) { return onCurve(e); });
}

bool LabelledMesh::isFolded(Face f) const {
    const auto lies = [this](Face face) {
        return std::ranges::all_of(corners(face), [](const Eigen::Vector3d& x) { return x.z() == 0; });
    };
    const auto edges = m_mesh.fh_range(f);
    return lies(f) && std::any_of(edges.begin(), edges.end(), [&](Halfedge h) {
               return onCurve(m_mesh.edge_handle(h)) && lies(m_mesh.opposite_face_handle(h));
           });
}

std::vector<LabelledMesh::Face> LabelledMesh::facesAbout(Vertex v, int rings) const {
    std::set<Vertex> seen{v};
    std::set<Face> faces;
    std::vector<Vertex> front{v};
    for (int ring = 0; ring < rings; ++ring) {
        std::vector<Vertex> next;
        for (const Vertex r : front) {
            for (const auto f : m_mesh.vf_range(r))
                faces.insert(f);
            for (const auto w : m_mesh.vv_range(r))
                if (seen.insert(w).second)
                    next.push_back(w);
        }
        front = std::move(next);
    }
    return {faces.begin(), faces.end()};
}

LabelledSurface LabelledMesh::surfaceOf(const std::vector<Face>& faces, const std::vector<Vertex>& points,
                                        const std::map<Vertex, Vertex>& copy) const {
    LabelledSurface surface;
    surface.mesh.V.resize(static_cast<Eigen::Index>(points.size()), 3);
    surface.mesh.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t v = 0; v < points.size(); ++v) {
        surface.mesh.V.row(static_cast<Eigen::Index>(v)) = point(points[v]).transpose();
        surface.sourceVertex.push_back(m_mesh.property(m_source, points[v]));
    }
    for (std::size_t f = 0; f < faces.size(); ++f) {
        Eigen::Index k = 0;
        for (const auto v : m_mesh.fv_range(faces[f]))
            surface.mesh.F(static_cast<Eigen::Index>(f), k++) = copy.at(v).idx();
        surface.labels.push_back(m_mesh.property(m_label, faces[f]));
    }
    return surface;
}

/// The points of this mesh's line that the patch does not move.
std::vector<Point2> LabelledMesh::lineBeyond(const LabelledPatch& patch) const {
    std::vector<Point2> beyond;
    for (const Vertex v : m_curvePoints) {
        const Vertex there = patch.at(v);
        if (!there.is_valid() || patch.mesh.onRim(there))
            beyond.emplace_back(point(v).head<2>());
    }
    return beyond;
}

std::optional<LabelledPatch> LabelledMesh::patchAbout(Vertex v, int rings) const {
    const std::vector<Face> faces = facesAbout(v, rings);
    std::vector<Vertex> points;
    std::map<Vertex, Vertex> copy;
    for (const Face f : faces)
        for (const auto w : m_mesh.fv_range(f))
            if (copy.try_emplace(w, static_cast<int>(points.size())).second)
                points.push_back(w);
    const LabelledSurface surface = surfaceOf(faces, points, copy);
    if (!rimIsSimple(surface.mesh.F))
        return std::nullopt;
    LabelledPatch patch{LabelledMesh(surface), std::move(points), std::move(copy)};
    patch.mesh.m_lineBeyond = std::make_shared<const std::vector<Point2>>(lineBeyond(patch));
    return patch;
}

LabelledMesh::Vertex LabelledPatch::at(LabelledMesh::Vertex v) const {
    const auto found = copy.find(v);
    return found == copy.end() ? LabelledMesh::Vertex() : found->second;
}

bool LabelledMesh::mayFlip(Edge e) {
    if (onCurve(e) || !m_mesh.is_flip_ok(e))
        return false;
    const Halfedge h = m_mesh.halfedge_handle(e, 0);
    const Halfedge o = m_mesh.halfedge_handle(e, 1);
    const Vertex c = m_mesh.to_vertex_handle(m_mesh.next_halfedge_handle(h));
    const Vertex d = m_mesh.to_vertex_handle(m_mesh.next_halfedge_handle(o));
    if (onRim(c) && onRim(d))
        return false; // beyond the rim they may be joined already
    const bool acrossInPlane = onPlane(c) && onPlane(d);
    return !(acrossInPlane && (onPlane(m_mesh.from_vertex_handle(h)) || onPlane(m_mesh.to_vertex_handle(h))));
}

bool LabelledMesh::mayCollapse(Halfedge h) {
    if (onRim(m_mesh.from_vertex_handle(h)) || onRim(m_mesh.to_vertex_handle(h)))
        return false;
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
    const double margin = kMargin * (at(gone) - at(kept)).norm();
    const auto swept = [&](const Point2& q) { return sweepsOver(q, at(p), at(gone), at(kept), margin); };
    return std::none_of(m_curvePoints.begin(), m_curvePoints.end(),
                        [&](Vertex v) { return v != p && v != gone && v != kept && swept(at(v)); }) &&
           (!m_lineBeyond || std::ranges::none_of(*m_lineBeyond, swept));
}

/// After a collapse the loop would be p – kept – q: too short when p and q are joined by the line or the
/// same.
bool LabelledMesh::loopIsShort(Vertex p, Vertex q) const {
    if (p == q || (onRim(p) && onRim(q)))
        return true;
    const Halfedge h = m_mesh.find_halfedge(p, q);
    return h.is_valid() && onCurve(m_mesh.edge_handle(h));
}

} // namespace moldwright

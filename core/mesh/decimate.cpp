// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/decimate.h"

#include "mesh/triangle_mesh.h"

#include <OpenMesh/Core/Geometry/QuadricT.hh>

#include <algorithm>
#include <numeric>
#include <queue>
#include <utility>

namespace moldwright {

namespace {

constexpr double kSlimmest = 12; ///< longest edge over height: slimmer faces may not be made
/// Weight of an edge's length to the fourth beside the quadric: where the surface is flat all collapses are
/// free, and only short edges first make faces of even size.
constexpr double kShortFirst = 1e-3;

double slimness(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return longest / std::max((b - a).cross(c - a).norm(), 1e-300);
}

/// Halfedge collapses, the cheapest first [Garland & Heckbert 1997]. What a collapse costs is found anew only
/// about the last one, and whether it is allowed only for the cheapest; OpenMesh's decimater asks both of
/// the whole neighbourhood at every step, which takes ten times as long.
class Decimation {
public:
    explicit Decimation(TriangleMesh& mesh)
        : m_mesh(mesh), m_quadrics(mesh.n_vertices()), m_stamps(mesh.n_vertices(), 0),
          m_refused(mesh.n_vertices(), 0), m_into(mesh.n_vertices()) {
        std::iota(m_into.begin(), m_into.end(), 0);
        for (const auto f : mesh.faces())
            addPlane(f);
        for (const auto h : mesh.halfedges())
            push(h);
    }

    /// Collapses until at most `targetFaces` are left or none is allowed.
    void run(std::size_t targetFaces) {
        std::size_t faces = m_mesh.n_faces();
        while (faces > targetFaces && !m_queue.empty()) {
            const Candidate next = m_queue.top();
            m_queue.pop();
            const TriangleMesh::HalfedgeHandle h(next.halfedge);
            if (m_mesh.status(m_mesh.edge_handle(h)).deleted() || next.stamp != stamp(h))
                continue;
            if (allowed(h)) {
                faces -=
                    m_mesh.is_boundary(h) || m_mesh.is_boundary(m_mesh.opposite_halfedge_handle(h)) ? 1 : 2;
                collapse(h);
            } else {
                m_refused[from(h)] = 1;
            }
        }
    }

    /// The point that v was merged into at last.
    int mergedInto(int v) {
        int last = v;
        while (m_into[static_cast<std::size_t>(last)] != last)
            last = m_into[static_cast<std::size_t>(last)];
        while (m_into[static_cast<std::size_t>(v)] != last)
            v = std::exchange(m_into[static_cast<std::size_t>(v)], last);
        return last;
    }

private:
    using Quadric = OpenMesh::Geometry::Quadricd;
    using Halfedge = TriangleMesh::HalfedgeHandle;
    using Vertex = TriangleMesh::VertexHandle;

    struct Candidate {
        double cost;
        int halfedge;
        unsigned stamp; ///< sum of its points' when the cost was found: they only grow
        bool operator<(const Candidate& other) const {
            return std::pair(cost, halfedge) > std::pair(other.cost, other.halfedge);
        }
    };

    [[nodiscard]] std::size_t from(Halfedge h) const {
        return static_cast<std::size_t>(m_mesh.from_vertex_handle(h).idx());
    }
    [[nodiscard]] std::size_t to(Halfedge h) const {
        return static_cast<std::size_t>(m_mesh.to_vertex_handle(h).idx());
    }
    [[nodiscard]] unsigned stamp(Halfedge h) const { return m_stamps[from(h)] + m_stamps[to(h)]; }
    [[nodiscard]] bool locked(Vertex v) const { return m_mesh.status(v).locked(); }

    void addPlane(TriangleMesh::FaceHandle f) {
        const Halfedge h = m_mesh.halfedge_handle(f);
        const Eigen::Vector3d& p = m_mesh.point(m_mesh.from_vertex_handle(h));
        const Eigen::Vector3d& q = m_mesh.point(m_mesh.to_vertex_handle(h));
        const Eigen::Vector3d& r = m_mesh.point(m_mesh.to_vertex_handle(m_mesh.next_halfedge_handle(h)));
        Eigen::Vector3d normal = (q - p).cross(r - p);
        const double length = normal.norm();
        if (length == 0)
            return;
        normal /= length;
        Quadric plane(normal.x(), normal.y(), normal.z(), -normal.dot(p));
        plane *= length / 2;
        for (const auto v : m_mesh.fv_range(f))
            m_quadrics[static_cast<std::size_t>(v.idx())] += plane;
    }

    void push(Halfedge h) {
        if (locked(m_mesh.from_vertex_handle(h)))
            return;
        const Eigen::Vector3d& left = m_mesh.point(m_mesh.to_vertex_handle(h));
        const Quadric both = m_quadrics[from(h)] + m_quadrics[to(h)];
        const double length = (left - m_mesh.point(m_mesh.from_vertex_handle(h))).squaredNorm();
        m_queue.push({both(left) + kShortFirst * length * length, h.idx(), stamp(h)});
    }

    /// Topology stays, no face turns over, none gets slim, or slimmer, none lies wholly on locked points.
    [[nodiscard]] bool allowed(Halfedge h) {
        if (!m_mesh.is_collapse_ok(h))
            return false;
        const Vertex v0 = m_mesh.from_vertex_handle(h);
        const Vertex v1 = m_mesh.to_vertex_handle(h);
        const Eigen::Vector3d& p0 = m_mesh.point(v0);
        const Eigen::Vector3d& p1 = m_mesh.point(v1);
        for (const auto out : m_mesh.voh_range(v0)) {
            const Vertex a = m_mesh.to_vertex_handle(out);
            const Vertex b = m_mesh.to_vertex_handle(m_mesh.next_halfedge_handle(out));
            if (m_mesh.is_boundary(out) || a == v1 || b == v1)
                continue;
            const Eigen::Vector3d& pa = m_mesh.point(a);
            const Eigen::Vector3d& pb = m_mesh.point(b);
            if ((pa - p0).cross(pb - p0).dot((pa - p1).cross(pb - p1)) < 0 ||
                (locked(v1) && locked(a) && locked(b)))
                return false;
            const double now = slimness(p1, pa, pb);
            if (now > kSlimmest && now > slimness(p0, pa, pb))
                return false;
        }
        return true;
    }

    void collapse(Halfedge h) {
        const Vertex gone = m_mesh.from_vertex_handle(h);
        const Vertex left = m_mesh.to_vertex_handle(h);
        const auto g = static_cast<std::size_t>(gone.idx());
        const auto l = static_cast<std::size_t>(left.idx());
        m_mesh.collapse(h);
        m_into[g] = left.idx();
        m_quadrics[l] += m_quadrics[g];
        m_stamps[l] = std::max(m_stamps[l], m_stamps[g]) + 1;
        for (const auto out : m_mesh.voh_range(left)) {
            push(out);
            push(m_mesh.opposite_halfedge_handle(out));
            offerAgain(m_mesh.to_vertex_handle(out));
        }
    }

    /// What was refused may be allowed now that the neighbourhood has changed.
    void offerAgain(Vertex v) {
        if (!std::exchange(m_refused[static_cast<std::size_t>(v.idx())], 0))
            return;
        for (const auto out : m_mesh.voh_range(v))
            push(out);
    }

    TriangleMesh& m_mesh;
    std::vector<Quadric> m_quadrics; ///< squared distance to the planes of all faces merged so far
    std::vector<unsigned> m_stamps;  ///< per point: raised whenever its quadric changes
    std::vector<char> m_refused;     ///< per point: a collapse of it was not allowed
    std::vector<int> m_into;
    std::priority_queue<Candidate> m_queue;
};

/// Collapses edges until `targetFaces` are left; which point each was merged into, as they were numbered
/// before.
std::vector<int> collapse(TriangleMesh& mesh, int targetFaces) {
    const auto points = static_cast<int>(mesh.n_vertices());
    Decimation decimation(mesh);
    decimation.run(static_cast<std::size_t>(targetFaces));
    mesh.garbage_collection();
    std::vector<int> into;
    into.reserve(static_cast<std::size_t>(points));
    for (int v = 0; v < points; ++v)
        into.push_back(decimation.mergedInto(v));
    return into;
}

} // namespace

IndexedMesh decimate(const IndexedMesh& mesh, int targetFaces) {
    return reduce(mesh, targetFaces).mesh;
}

Reduction reduce(const IndexedMesh& mesh, int targetFaces, const std::vector<char>& kept) {
    std::vector<int> pointNow(static_cast<std::size_t>(mesh.vertexCount()));
    std::iota(pointNow.begin(), pointNow.end(), 0);
    if (mesh.faceCount() <= targetFaces)
        return {mesh, std::move(pointNow)};
    TriangleMesh reduced = toTriangleMesh(mesh);
    OpenMesh::VPropHandleT<int> original;
    reduced.add_property(original);
    for (const auto v : reduced.vertices()) {
        reduced.property(original, v) = v.idx();
        reduced.status(v).set_locked(!kept.empty() && kept[static_cast<std::size_t>(v.idx())]);
    }
    const std::vector<int> into = collapse(reduced, targetFaces);
    std::vector<int> placeOf(pointNow.size(), -1);
    for (const auto v : reduced.vertices())
        placeOf[static_cast<std::size_t>(reduced.property(original, v))] = v.idx();
    for (int& v : pointNow)
        v = placeOf[static_cast<std::size_t>(into[static_cast<std::size_t>(v)])];
    return {toIndexedMesh(reduced), std::move(pointNow)};
}

} // namespace moldwright

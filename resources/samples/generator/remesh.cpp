// SPDX-License-Identifier: AGPL-3.0-or-later
#include "remesh.h"

#include "base/parallel.h"
#include "mesh/triangle_mesh.h"

#include <Eigen/Eigenvalues>
#include <OpenMesh/Core/Utils/PropertyManager.hh>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace moldwright::samples {

namespace {

using Vertex = OpenMesh::SmartVertexHandle;
using Edge = OpenMesh::SmartEdgeHandle;
using Halfedge = OpenMesh::SmartHalfedgeHandle;
using Face = OpenMesh::SmartFaceHandle;

class Remesher {
public:
    Remesher(const IndexedMesh& mesh, const Solid& solid, const Fineness& fineness)
        : m_mesh(toTriangleMesh(mesh)), m_solid(solid), m_fineness(fineness), m_length(m_mesh) {}

    IndexedMesh run() {
        for (int round = 0; round < 8; ++round) {
            chooseLengths();
            splitLongEdges();
            collapseShortEdges();
            flipEdges([this](Edge e) { return improvesValence(e); });
            for (int k = 0; k < 2; ++k)
                relax();
        }
        for (int round = 0; round < 6; ++round) {
            flipEdges([this](Edge e) { return improvesAngles(e); });
            relax();
        }
        m_mesh.garbage_collection();
        return toIndexedMesh(m_mesh);
    }

private:
    // --- where a vertex may go ---

    [[nodiscard]] bool onBack(Vertex v) const { return m_solid.flatBack && m_mesh.point(v).z() == 0; }
    [[nodiscard]] bool onBack(Face f) const {
        return f.vertices().all_of([this](Vertex v) { return onBack(v); });
    }
    [[nodiscard]] bool isRim(Edge e) const { return onBack(e.h0().face()) != onBack(e.h1().face()); }
    [[nodiscard]] bool onRim(Vertex v) const {
        return onBack(v) && v.faces().any_of([this](Face f) { return !onBack(f); });
    }

    // --- lengths ---

    [[nodiscard]] double lengthAt(const Vector3d& p) const {
        const Taylor t = expand(m_solid.field, p, m_fineness.shortest / 3);
        const double slope = std::max(t.gradient.norm(), 1e-6);
        const Vector3d n = t.gradient / slope;
        const Eigen::Matrix3d P = Eigen::Matrix3d::Identity() - n * n.transpose();
        const Eigen::Matrix3d H = P * t.hessian * P / slope;
        const double curvature = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(H, Eigen::EigenvaluesOnly)
                                     .eigenvalues()
                                     .cwiseAbs()
                                     .maxCoeff();
        const double deviation = m_fineness.deviation;
        const double length =
            std::sqrt(std::max(6 * deviation / std::max(curvature, 1e-9) - 3 * deviation * deviation, 0.0));
        return std::clamp(length, m_fineness.shortest, m_fineness.longest);
    }

    void chooseLengths() {
        parallelFor(m_mesh.n_vertices(), 256, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const Vertex v = OpenMesh::make_smart(OpenMesh::VertexHandle(int(k)), m_mesh);
                m_length[v] = onBack(v) && !onRim(v) ? m_fineness.longest : lengthAt(m_mesh.point(v));
            }
        });
        constexpr double growth = 0.5; // of the length per mm along the surface
        for (int sweep = 0; sweep < 15; ++sweep)
            for (const Halfedge h : m_mesh.halfedges())
                m_length[h.to()] =
                    std::min(m_length[h.to()], m_length[h.from()] + growth * edgeLength(h.edge()));
    }

    [[nodiscard]] double edgeLength(Edge e) const {
        return (m_mesh.point(e.v0()) - m_mesh.point(e.v1())).norm();
    }
    [[nodiscard]] double wanted(Vertex a, Vertex b) const { return std::min(m_length[a], m_length[b]); }

    // --- topology ---

    void splitLongEdges() {
        for (int sweep = 0; sweep < 3; ++sweep)
            for (std::size_t k = 0, count = m_mesh.n_edges(); k < count; ++k) {
                const Edge e = OpenMesh::make_smart(OpenMesh::EdgeHandle(int(k)), m_mesh);
                if (edgeLength(e) <= 4.0 / 3 * wanted(e.v0(), e.v1()))
                    continue;
                const double length = (m_length[e.v0()] + m_length[e.v1()]) / 2;
                const Vertex v = m_mesh.add_vertex((m_mesh.point(e.v0()) + m_mesh.point(e.v1())) / 2);
                m_mesh.split(e, v);
                m_length[v] = length;
            }
    }

    void collapseShortEdges() {
        for (std::size_t k = 0, count = m_mesh.n_halfedges(); k < count; ++k) {
            const Halfedge h = OpenMesh::make_smart(OpenMesh::HalfedgeHandle(int(k)), m_mesh);
            if (m_mesh.status(h.edge()).deleted())
                continue;
            if (edgeLength(h.edge()) < 4.0 / 5 * wanted(h.from(), h.to()) && mayCollapse(h))
                m_mesh.collapse(h);
        }
        m_mesh.garbage_collection();
    }

    [[nodiscard]] bool mayCollapse(Halfedge h) {
        const Vertex from = h.from();
        const Vertex to = h.to();
        if (!m_mesh.is_collapse_ok(h))
            return false;
        if (onRim(from) && !isRim(h.edge()))
            return false;
        if (onBack(from) && !onBack(to))
            return false;
        for (const Vertex v : from.vertices())
            if ((m_mesh.point(v) - m_mesh.point(to)).norm() > 4.0 / 3 * wanted(v, to))
                return false;
        return keepsShape(from, m_mesh.point(to), to);
    }

    /// Whether the faces about v keep facing their way when it goes to p; those with `except` vanish.
    [[nodiscard]] bool keepsShape(Vertex v, const Vector3d& p, std::optional<Vertex> except = {}) const {
        for (const Halfedge h : v.outgoing_halfedges()) {
            const Vertex a = h.to();
            const Vertex b = h.next().to();
            if (except && (a == *except || b == *except))
                continue;
            const Vector3d ea = m_mesh.point(a);
            const Vector3d eb = m_mesh.point(b);
            const Vector3d before = (ea - m_mesh.point(v)).cross(eb - m_mesh.point(v));
            const Vector3d after = (ea - p).cross(eb - p);
            if (after.dot(before) < 0.3 * after.norm() * before.norm() || after.norm() < 1e-9)
                return false;
            // A face of the round side must not fall into the back.
            if (except && onBack(*except) && onBack(a) && onBack(b) && !onBack(h.face()))
                return false;
        }
        return true;
    }

    template <class Improves>
    void flipEdges(Improves improves) {
        for (const Edge e : m_mesh.edges())
            if (!isRim(e) && m_mesh.is_flip_ok(e) && improves(e) && mayFlip(e))
                m_mesh.flip(e);
    }

    /// The four corners of an edge's two faces: its ends, then what lies across.
    struct Diamond {
        Vertex a, b, c, d;
    };
    [[nodiscard]] static Diamond diamond(Edge e) {
        return {e.v0(), e.v1(), e.h0().next().to(), e.h1().next().to()};
    }

    [[nodiscard]] bool improvesValence(Edge e) const {
        const auto [a, b, c, d] = diamond(e);
        const auto off = [](Vertex v, int change) { return std::abs(int(v.valence()) + change - 6); };
        return off(a, -1) + off(b, -1) + off(c, 1) + off(d, 1) <
               off(a, 0) + off(b, 0) + off(c, 0) + off(d, 0);
    }

    /// Delaunay's criterion: the angles that face the edge add up to more than half a turn.
    [[nodiscard]] bool improvesAngles(Edge e) const {
        const auto [a, b, c, d] = diamond(e);
        return angle(c, a, b) + angle(d, a, b) > 1.02 * EIGEN_PI;
    }

    [[nodiscard]] double angle(Vertex at, Vertex a, Vertex b) const {
        const Vector3d u = m_mesh.point(a) - m_mesh.point(at);
        const Vector3d v = m_mesh.point(b) - m_mesh.point(at);
        return std::atan2(u.cross(v).norm(), u.dot(v));
    }

    [[nodiscard]] bool mayFlip(Edge e) const {
        const auto [a, b, c, d] = diamond(e);
        if (onBack(c) && onBack(d) && !(onBack(a) && onBack(b)))
            return false;
        const auto normal = [this](Vertex p, Vertex q, Vertex r) -> Vector3d {
            return (m_mesh.point(q) - m_mesh.point(p)).cross(m_mesh.point(r) - m_mesh.point(p)).normalized();
        };
        const Vector3d before = normal(a, b, c) + normal(b, a, d);
        return normal(c, d, b).dot(before) > before.norm() / 2 &&
               normal(d, c, a).dot(before) > before.norm() / 2;
    }

    // --- places ---

    void relax() {
        std::vector<Vector3d> targets(m_mesh.n_vertices());
        parallelFor(targets.size(), 256, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
                targets[k] = relaxed(OpenMesh::make_smart(OpenMesh::VertexHandle(int(k)), m_mesh));
        });
        for (const Vertex v : m_mesh.vertices())
            if (keepsShape(v, targets[std::size_t(v.idx())]))
                m_mesh.set_point(v, targets[std::size_t(v.idx())]);
    }

    /// Where v would lie evenly among its neighbours: moved within the surface, then drawn onto it by chords
    /// along its normal; within the back when it lies there.
    [[nodiscard]] Vector3d relaxed(Vertex v) const {
        const bool flat = onBack(v);
        const bool rim = flat && onRim(v);
        Vector3d p = rim ? alongRim(v) : amongFaces(v);
        if (flat && !rim)
            return p;
        Vector3d g = gradient(m_solid.field, m_mesh.point(v));
        if (flat)
            g.z() = 0;
        g /= std::max(g.squaredNorm(), 1e-3); // a step along g changes the field by 1
        p -= g * g.dot(p - m_mesh.point(v)) / g.squaredNorm();
        const double limit = m_fineness.shortest / g.norm();
        for (int k = 0; k < 2; ++k)
            p -= std::clamp(m_solid.field(p), -limit, limit) * g;
        return p;
    }

    /// Centroid of the faces about v, each weighed so that lengths follow what is wanted.
    [[nodiscard]] Vector3d amongFaces(Vertex v) const {
        Vector3d sum = Vector3d::Zero();
        double weights = 0;
        for (const Halfedge h : v.outgoing_halfedges()) {
            const Vector3d a = m_mesh.point(v);
            const Vector3d b = m_mesh.point(h.to());
            const Vector3d c = m_mesh.point(h.next().to());
            const double length = (m_length[v] + m_length[h.to()] + m_length[h.next().to()]) / 3;
            const double weight = (b - a).cross(c - a).norm() / (length * length);
            sum += weight * (a + b + c) / 3;
            weights += weight;
        }
        return sum / weights;
    }

    [[nodiscard]] Vector3d alongRim(Vertex v) const {
        Vector3d sum = Vector3d::Zero();
        for (const Halfedge h : v.outgoing_halfedges())
            if (isRim(h.edge()))
                sum += m_mesh.point(h.to()) / 2;
        return sum;
    }

    TriangleMesh m_mesh;
    const Solid& m_solid;
    Fineness m_fineness;
    OpenMesh::VProp<double> m_length;
};

} // namespace

IndexedMesh remesh(const IndexedMesh& mesh, const Solid& solid, const Fineness& fineness) {
    return Remesher(mesh, solid, fineness).run();
}

} // namespace moldwright::samples

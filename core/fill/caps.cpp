// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/caps.h"

#include "mesh/triangle_mesh.h"

#include <algorithm>
#include <array>

namespace moldwright {

namespace {

constexpr int kRounds = 10; ///< a cap may lie on another one

class Caps {
public:
    Caps(FilledPart& part, double flat)
        : m_surface(part.surface), m_mesh(toTriangleMesh(part.surface.mesh)), m_flat(flat) {}

    /// Returns whether any was turned.
    bool flipOnce() {
        bool any = false;
        for (const auto f : m_mesh.faces()) {
            const Halfedge longest = longestEdge(f);
            if (heightOver(longest) < m_flat && mayFlip(longest)) {
                const auto beside = m_mesh.face_handle(m_mesh.opposite_halfedge_handle(longest));
                source(f) = source(beside);
                m_mesh.flip(m_mesh.edge_handle(longest));
                any = true;
            }
        }
        return any;
    }

    void finish() {
        for (const auto f : m_mesh.faces()) {
            Eigen::Index k = 0;
            for (const auto v : m_mesh.fv_range(f))
                m_surface.mesh.F(f.idx(), k++) = v.idx();
        }
    }

private:
    using Halfedge = TriangleMesh::HalfedgeHandle;
    using Vertex = TriangleMesh::VertexHandle;
    using Face = TriangleMesh::FaceHandle;

    [[nodiscard]] int& source(Face f) { return m_surface.sourceFace[static_cast<std::size_t>(f.idx())]; }

    [[nodiscard]] Halfedge longestEdge(Face f) const {
        Halfedge longest = m_mesh.halfedge_handle(f);
        for (Halfedge h = m_mesh.next_halfedge_handle(longest); h != m_mesh.halfedge_handle(f);
             h = m_mesh.next_halfedge_handle(h))
            if (m_mesh.calc_edge_length(h) > m_mesh.calc_edge_length(longest))
                longest = h;
        return longest;
    }

    /// The corner of a halfedge's face that is not on it.
    [[nodiscard]] Vertex apex(Halfedge h) const {
        return m_mesh.to_vertex_handle(m_mesh.next_halfedge_handle(h));
    }

    [[nodiscard]] Eigen::Vector3d up(Vertex a, Vertex b, Vertex c) const {
        const Eigen::Vector3d at = m_mesh.point(a);
        return (m_mesh.point(b) - at).cross(m_mesh.point(c) - at);
    }

    [[nodiscard]] double heightOver(Halfedge h) const {
        return up(m_mesh.from_vertex_handle(h), m_mesh.to_vertex_handle(h), apex(h)).norm() /
               m_mesh.calc_edge_length(h);
    }

    /// Whether the neighbour, cut from its far corner to the cap's middle point, falls into two sound faces.
    [[nodiscard]] bool mayFlip(Halfedge h) const {
        const Halfedge back = m_mesh.opposite_halfedge_handle(h);
        const auto label = [&](Halfedge side) {
            return m_surface.labels[static_cast<std::size_t>(m_mesh.face_handle(side).idx())];
        };
        if (label(h) != label(back) || !m_mesh.is_flip_ok(m_mesh.edge_handle(h)))
            return false;
        const Vertex a = m_mesh.from_vertex_handle(h);
        const Vertex b = m_mesh.to_vertex_handle(h);
        const Vertex middle = apex(h);
        const Vertex far = apex(back);
        const Eigen::Vector3d before = up(b, a, far);
        return up(middle, a, far).dot(before) > 0 && up(b, middle, far).dot(before) > 0;
    }

    PartedMesh& m_surface;
    TriangleMesh m_mesh;
    double m_flat;
};

} // namespace

void flipCaps(FilledPart& part, double flat) {
    Caps caps(part, flat);
    for (int round = 0; round < kRounds && caps.flipOnce(); ++round) {
    }
    caps.finish();
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/short_edges.h"

#include "mesh/triangle_mesh.h"

#include <algorithm>
#include <array>

namespace moldwright {

namespace {

constexpr int kRounds = 5; ///< a collapse may make room for the next

class ShortEdges {
public:
    ShortEdges(FilledPart& part, double shortest)
        : m_part(part), m_mesh(toTriangleMesh(part.surface.mesh)), m_shortest(shortest) {}

    /// Returns whether any went.
    bool collapseOnce() {
        bool any = false;
        for (const auto e : m_mesh.edges()) {
            if (m_mesh.status(e).deleted() || m_mesh.calc_edge_length(e) >= m_shortest)
                continue;
            for (const unsigned way : {0U, 1U})
                if (const auto h = m_mesh.halfedge_handle(e, way); mayGo(h)) {
                    m_mesh.collapse(h);
                    any = true;
                    break;
                }
        }
        return any;
    }

    void finish() {
        PartedMesh& surface = m_part.surface;
        Eigen::Index count = 0;
        for (const auto f : m_mesh.all_faces()) {
            if (m_mesh.status(f).deleted())
                continue;
            Eigen::Index k = 0;
            for (const auto v : m_mesh.fv_range(f))
                surface.mesh.F(count, k++) = v.idx();
            surface.labels[static_cast<std::size_t>(count)] = label(f);
            surface.sourceFace[static_cast<std::size_t>(count)] =
                surface.sourceFace[static_cast<std::size_t>(f.idx())];
            ++count;
        }
        surface.mesh.F.conservativeResize(count, 3);
        surface.labels.resize(static_cast<std::size_t>(count));
        surface.sourceFace.resize(static_cast<std::size_t>(count));
        dropUnusedPoints();
    }

private:
    using Halfedge = TriangleMesh::HalfedgeHandle;
    using Vertex = TriangleMesh::VertexHandle;

    [[nodiscard]] std::uint8_t label(TriangleMesh::FaceHandle f) const {
        return m_part.surface.labels[static_cast<std::size_t>(f.idx())];
    }

    [[nodiscard]] bool onPartingLine(Vertex v) {
        const auto faces = m_mesh.vf_range(v);
        return std::any_of(faces.begin(), faces.end(),
                           [&](auto f) { return label(f) != label(*faces.begin()); });
    }

    /// Whether a halfedge's first point may go to its last.
    [[nodiscard]] bool mayGo(Halfedge h) {
        const Vertex from = m_mesh.from_vertex_handle(h);
        const auto back = m_mesh.opposite_halfedge_handle(h);
        const bool alongLine = label(m_mesh.face_handle(h)) != label(m_mesh.face_handle(back));
        return m_part.sourceVertex[static_cast<std::size_t>(from.idx())] < 0 && m_mesh.is_collapse_ok(h) &&
               (alongLine || !onPartingLine(from)) && keepsFaces(h);
    }

    [[nodiscard]] bool keepsFaces(Halfedge h) {
        const Vertex from = m_mesh.from_vertex_handle(h);
        const Vertex to = m_mesh.to_vertex_handle(h);
        for (const auto f : m_mesh.vf_range(from)) {
            std::array<Eigen::Vector3d, 3> before;
            std::array<Eigen::Vector3d, 3> after;
            std::size_t k = 0;
            bool vanishes = false;
            for (const auto v : m_mesh.fv_range(f)) {
                before[k] = m_mesh.point(v);
                after[k++] = m_mesh.point(v == from ? to : v);
                vanishes = vanishes || v == to;
            }
            const auto up = [](const std::array<Eigen::Vector3d, 3>& x) -> Eigen::Vector3d {
                return (x[1] - x[0]).cross(x[2] - x[0]);
            };
            // Of needles whose short side goes rounding tells the side; they get no worse.
            if (!vanishes && up(after).dot(up(before)) <= 0)
                return false;
        }
        return true;
    }

    void dropUnusedPoints() {
        IndexedMesh& mesh = m_part.surface.mesh;
        std::vector<int> number(static_cast<std::size_t>(mesh.vertexCount()), -1);
        for (const int v : mesh.F.reshaped())
            number[static_cast<std::size_t>(v)] = 0;
        int count = 0;
        for (std::size_t v = 0; v < number.size(); ++v) {
            if (number[v] < 0)
                continue;
            mesh.V.row(count) = mesh.V.row(static_cast<Eigen::Index>(v)).eval();
            m_part.sourceVertex[static_cast<std::size_t>(count)] = m_part.sourceVertex[v];
            number[v] = count++;
        }
        mesh.V.conservativeResize(count, 3);
        m_part.sourceVertex.resize(static_cast<std::size_t>(count));
        mesh.F = mesh.F.unaryExpr([&](int v) { return number[static_cast<std::size_t>(v)]; }).eval();
    }

    FilledPart& m_part;
    TriangleMesh m_mesh;
    double m_shortest;
};

} // namespace

void collapseShortEdges(FilledPart& part, double shortest) {
    ShortEdges edges(part, shortest);
    for (int round = 0; round < kRounds && edges.collapseOnce(); ++round) {
    }
    edges.finish();
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/cgal/solid_union.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

#include <exception>

namespace moldwright {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

std::optional<Mesh> surfaceMesh(const IndexedMesh& mesh) {
    Mesh result;
    std::vector<Mesh::Vertex_index> vertices;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        vertices.push_back(result.add_vertex({mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)}));
    for (const auto& f : mesh.F.rowwise())
        if (result.add_face(vertices[static_cast<std::size_t>(f[0])], vertices[static_cast<std::size_t>(f[1])],
                            vertices[static_cast<std::size_t>(f[2])]) == Mesh::null_face())
            return std::nullopt;
    return result;
}

IndexedMesh indexedMesh(const Mesh& mesh) {
    IndexedMesh result;
    result.V.resize(static_cast<Eigen::Index>(mesh.number_of_vertices()), 3);
    std::vector<int> numberOf(mesh.num_vertices(), -1);
    int count = 0;
    for (const auto v : mesh.vertices()) {
        const auto& p = mesh.point(v);
        result.V.row(count) << p.x(), p.y(), p.z();
        numberOf[v] = count++;
    }
    result.F.resize(static_cast<Eigen::Index>(mesh.number_of_faces()), 3);
    int row = 0;
    for (const auto f : mesh.faces()) {
        int k = 0;
        for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
            result.F(row, k++) = numberOf[v];
        ++row;
    }
    return result;
}

} // namespace

std::optional<IndexedMesh> unionOfSolids(const IndexedMesh& a, const IndexedMesh& b) try {
    std::optional<Mesh> first = surfaceMesh(a);
    std::optional<Mesh> second = surfaceMesh(b);
    if (!first || !second)
        return std::nullopt;
    namespace pmp = CGAL::Polygon_mesh_processing;
    Mesh joined;
    if (!pmp::corefine_and_compute_union(*first, *second, joined))
        return std::nullopt;
    joined.collect_garbage();
    return indexedMesh(joined);
} catch (const std::exception&) {
    // CGAL's assertions throw; a degenerate case it does not like is an answer, not a crash.
    return std::nullopt;
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/cgal/solid_union.h"

#include "base/stop_point.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <exception>
#include <numeric>

namespace moldwright {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

std::optional<Mesh> surfaceMesh(const IndexedMesh& mesh) {
    Mesh result;
    std::vector<Mesh::Vertex_index> vertices;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        vertices.push_back(result.add_vertex({mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)}));
    for (const auto& f : mesh.F.rowwise()) {
        stopPointAt(f[0]);
        if (result.add_face(vertices[static_cast<std::size_t>(f[0])],
                            vertices[static_cast<std::size_t>(f[1])],
                            vertices[static_cast<std::size_t>(f[2])]) == Mesh::null_face())
            return std::nullopt;
    }
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

/// Points by their coordinates, faces by their points: what CGAL finds is the same each time, but not its
/// order.
IndexedMesh inFixedOrder(const IndexedMesh& mesh) {
    std::vector<int> points(static_cast<std::size_t>(mesh.vertexCount()));
    std::iota(points.begin(), points.end(), 0);
    std::sort(points.begin(), points.end(), [&](int a, int b) {
        return std::lexicographical_compare(mesh.V.row(a).begin(), mesh.V.row(a).end(), mesh.V.row(b).begin(),
                                            mesh.V.row(b).end());
    });
    std::vector<int> numberOf(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        numberOf[static_cast<std::size_t>(points[i])] = static_cast<int>(i);
    std::vector<std::array<int, 3>> faces;
    for (const auto& f : mesh.F.rowwise()) {
        std::array<int, 3> face{};
        for (std::size_t k = 0; k < 3; ++k)
            face[k] = numberOf[static_cast<std::size_t>(f[static_cast<Eigen::Index>(k)])];
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        faces.push_back(face);
    }
    std::sort(faces.begin(), faces.end());
    IndexedMesh ordered{mesh.V(points, Eigen::all), Triangles(mesh.F.rows(), 3)};
    for (std::size_t f = 0; f < faces.size(); ++f)
        ordered.F.row(static_cast<Eigen::Index>(f)) << faces[f][0], faces[f][1], faces[f][2];
    return ordered;
}

} // namespace

std::optional<IndexedMesh> unionOfSolids(const IndexedMesh& a, const IndexedMesh& b) try {
    std::optional<Mesh> first = surfaceMesh(a);
    std::optional<Mesh> second = surfaceMesh(b);
    if (!first || !second)
        return std::nullopt;
    stopPoint();
    namespace pmp = CGAL::Polygon_mesh_processing;
    Mesh joined;
    if (!pmp::corefine_and_compute_union(*first, *second, joined))
        return std::nullopt;
    stopPoint();
    joined.collect_garbage();
    return inFixedOrder(indexedMesh(joined));
} catch (const std::exception&) {
    // CGAL's assertions throw; a degenerate case it does not like is an answer, not a crash.
    return std::nullopt;
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/triangle_mesh.h"

#include <cassert>

namespace moldwright {

TriangleMesh toTriangleMesh(const IndexedMesh& mesh) {
    TriangleMesh result;
    result.reserve(static_cast<std::size_t>(mesh.vertexCount()),
                   static_cast<std::size_t>(mesh.faceCount()) * 3 / 2,
                   static_cast<std::size_t>(mesh.faceCount()));
    for (int v = 0; v < mesh.vertexCount(); ++v)
        result.add_vertex(mesh.point(v));
    for (int f = 0; f < mesh.faceCount(); ++f) {
        [[maybe_unused]] const auto face = result.add_face(TriangleMesh::VertexHandle(mesh.F(f, 0)),
                                                           TriangleMesh::VertexHandle(mesh.F(f, 1)),
                                                           TriangleMesh::VertexHandle(mesh.F(f, 2)));
        assert(face.is_valid() && face.idx() == f);
    }
    return result;
}

IndexedMesh toIndexedMesh(const TriangleMesh& mesh) {
    IndexedMesh result;
    result.V.resize(static_cast<Eigen::Index>(mesh.n_vertices()), 3);
    result.F.resize(static_cast<Eigen::Index>(mesh.n_faces()), 3);
    for (const auto v : mesh.vertices())
        result.V.row(v.idx()) = mesh.point(v).transpose();
    for (const auto f : mesh.faces()) {
        int k = 0;
        for (const auto v : mesh.fv_range(f))
            result.F(f.idx(), k++) = v.idx();
    }
    return result;
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

namespace moldwright {

using RepairKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using RepairPoint = RepairKernel::Point_3;
using RepairMesh = CGAL::Surface_mesh<RepairPoint>;

/// Points and faces that need not fit together.
struct RepairSoup {
    std::vector<RepairPoint> points;
    std::vector<std::array<std::size_t, 3>> faces;
};

[[nodiscard]] inline RepairSoup toSoup(const IndexedMesh& mesh) {
    RepairSoup soup;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        soup.points.emplace_back(mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2));
    for (int f = 0; f < mesh.faceCount(); ++f)
        soup.faces.push_back({static_cast<std::size_t>(mesh.F(f, 0)), static_cast<std::size_t>(mesh.F(f, 1)),
                              static_cast<std::size_t>(mesh.F(f, 2))});
    return soup;
}

/// Garbage is collected.
[[nodiscard]] inline IndexedMesh toIndexed(RepairMesh& surface) {
    surface.collect_garbage();
    IndexedMesh mesh;
    mesh.V.resize(static_cast<Eigen::Index>(surface.number_of_vertices()), 3);
    mesh.F.resize(static_cast<Eigen::Index>(surface.number_of_faces()), 3);
    for (const auto v : surface.vertices()) {
        const RepairPoint& p = surface.point(v);
        mesh.V.row(static_cast<Eigen::Index>(v.idx())) << p.x(), p.y(), p.z();
    }
    for (const auto f : surface.faces()) {
        int k = 0;
        for (const auto v : surface.vertices_around_face(surface.halfedge(f)))
            mesh.F(static_cast<Eigen::Index>(f.idx()), k++) = static_cast<int>(v.idx());
    }
    return mesh;
}

} // namespace moldwright

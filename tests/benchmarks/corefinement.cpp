// SPDX-License-Identifier: AGPL-3.0-or-later
#include "benchmarks/corefinement.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <vector>

namespace moldwright::bench {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh surfaceMesh(const IndexedMesh& mesh) {
    Mesh result;
    std::vector<Mesh::Vertex_index> vertices;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        vertices.push_back(result.add_vertex({mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)}));
    for (const auto& f : mesh.F.rowwise())
        result.add_face(vertices[static_cast<std::size_t>(f[0])], vertices[static_cast<std::size_t>(f[1])],
                        vertices[static_cast<std::size_t>(f[2])]);
    return result;
}

} // namespace

struct Corefinement::Meshes {
    std::array<Mesh, 2> blocks;
    std::array<Mesh, 2> cavities; ///< one for each half: corefinement changes it
    std::array<Mesh, 2> halves;
};

Corefinement::Corefinement(const std::array<IndexedMesh, 2>& blocks, const IndexedMesh& cavities)
    : m_meshes(std::make_unique<Meshes>()) {
    for (std::size_t half : {0UL, 1UL}) {
        m_meshes->blocks[half] = surfaceMesh(blocks[half]);
        m_meshes->cavities[half] = surfaceMesh(cavities);
    }
}

Corefinement::~Corefinement() = default;

bool Corefinement::run() {
    bool done = true;
    for (std::size_t half : {0UL, 1UL})
        done = pmp::corefine_and_compute_difference(m_meshes->blocks[half], m_meshes->cavities[half],
                                                    m_meshes->halves[half]) &&
               done;
    return done;
}

double Corefinement::volume() const {
    return CGAL::to_double(pmp::volume(m_meshes->halves[0]) + pmp::volume(m_meshes->halves[1]));
}

} // namespace moldwright::bench

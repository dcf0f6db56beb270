// SPDX-License-Identifier: AGPL-3.0-or-later
#include "pins/cgal/inside_test.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

namespace moldwright {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

Kernel::Point_3 pointOf(const Eigen::Vector3d& p) {
    return {p.x(), p.y(), p.z()};
}

Surface surfaceOf(const IndexedMesh& mesh) {
    Surface surface;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        surface.add_vertex(pointOf(mesh.point(v)));
    const auto at = [&](int f, int k) { return Surface::Vertex_index(static_cast<unsigned>(mesh.F(f, k))); };
    for (int f = 0; f < mesh.faceCount(); ++f)
        surface.add_face(at(f, 0), at(f, 1), at(f, 2));
    return surface;
}

} // namespace

struct InsideTest::Tree {
    explicit Tree(const IndexedMesh& mesh) : surface(surfaceOf(mesh)), side(surface) {
        // The tree is built when first asked for: here, before several threads do.
        side(pointOf(Eigen::Vector3d(mesh.V.colwise().mean().transpose())));
    }

    Surface surface;
    CGAL::Side_of_triangle_mesh<Surface, Kernel> side;
};

InsideTest::InsideTest(const IndexedMesh& mesh) : m_tree(std::make_unique<Tree>(mesh)) {}
InsideTest::~InsideTest() = default;

bool InsideTest::inside(const Eigen::Vector3d& p) const {
    return m_tree->side(pointOf(p)) == CGAL::ON_BOUNDED_SIDE;
}

} // namespace moldwright

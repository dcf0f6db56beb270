// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/cgal/face_pairs.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <array>
#include <utility>
#include <vector>

namespace moldwright {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

} // namespace

class FacePairs::Predicates {
public:
    explicit Predicates(const IndexedMesh& mesh) : m_mesh(mesh) {
        m_points.reserve(static_cast<std::size_t>(mesh.vertexCount()));
        for (int v = 0; v < mesh.vertexCount(); ++v)
            m_points.emplace_back(mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2));
    }

    [[nodiscard]] bool flat(int f) const { return CGAL::collinear(corner(f, 0), corner(f, 1), corner(f, 2)); }

    [[nodiscard]] bool cross(int f, int g) const {
        std::array<std::pair<int, int>, 3> common; // corner of f, corner of g
        std::size_t count = 0;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                if (m_mesh.F(f, i) == m_mesh.F(g, j) && count < common.size())
                    common[count++] = {i, j};
        switch (count) {
        case 0:
            return CGAL::do_intersect(triangle(f), triangle(g));
        case 1:
            return CGAL::do_intersect(sideOpposite(f, common[0].first), triangle(g)) ||
                   CGAL::do_intersect(sideOpposite(g, common[0].second), triangle(f));
        case 2:
            return foldedOver(f, common[0].first, common[1].first, g, common[0].second, common[1].second);
        default:
            return true;
        }
    }

private:
    [[nodiscard]] const Point& corner(int f, int k) const {
        return m_points[static_cast<std::size_t>(m_mesh.F(f, k % 3))];
    }
    [[nodiscard]] Kernel::Triangle_3 triangle(int f) const {
        return {corner(f, 0), corner(f, 1), corner(f, 2)};
    }
    [[nodiscard]] Kernel::Segment_3 sideOpposite(int f, int k) const {
        return {corner(f, k + 1), corner(f, k + 2)};
    }

    /// Two faces at an edge overlap when they lie in one plane on the same side of it.
    [[nodiscard]] bool foldedOver(int f, int i0, int i1, int g, int j0, int j1) const {
        const Point& a = corner(f, i0);
        const Point& b = corner(f, i1);
        const Point& c = corner(f, 3 - i0 - i1);
        const Point& d = corner(g, 3 - j0 - j1);
        return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
    }

    const IndexedMesh& m_mesh;
    std::vector<Point> m_points;
};

FacePairs::FacePairs(const IndexedMesh& mesh) : m_predicates(std::make_unique<Predicates>(mesh)) {}
FacePairs::~FacePairs() = default;

bool FacePairs::flat(int f) const {
    return m_predicates->flat(f);
}
bool FacePairs::cross(int f, int g) const {
    return m_predicates->cross(f, g);
}

} // namespace moldwright

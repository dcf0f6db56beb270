// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/closest_point.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <vector>

namespace moldwright {

namespace {

// Distances for people: plain doubles are exact enough.
using Kernel = CGAL::Simple_cartesian<double>;
using Triangle = Kernel::Triangle_3;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, std::vector<Triangle>::const_iterator>;

Kernel::Point_3 pointOf(const Eigen::Vector3d& p) {
    return {p.x(), p.y(), p.z()};
}

} // namespace

struct ClosestPoint::Tree {
    std::vector<Triangle> triangles;
    std::vector<int> faces; ///< that they are
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> boxes;
};

ClosestPoint::ClosestPoint(const IndexedMesh& mesh) : m_tree(std::make_unique<Tree>()) {
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const Triangle triangle(pointOf(mesh.corner(f, 0)), pointOf(mesh.corner(f, 1)),
                                pointOf(mesh.corner(f, 2)));
        if (triangle.is_degenerate())
            continue;
        m_tree->triangles.push_back(triangle);
        m_tree->faces.push_back(f);
    }
    m_tree->boxes.insert(m_tree->triangles.cbegin(), m_tree->triangles.cend());
    m_tree->boxes.build();
    m_tree->boxes.accelerate_distance_queries();
}

ClosestPoint::~ClosestPoint() = default;
ClosestPoint::ClosestPoint(ClosestPoint&&) noexcept = default;
ClosestPoint& ClosestPoint::operator=(ClosestPoint&&) noexcept = default;

double ClosestPoint::distance(const Eigen::Vector3d& p) const {
    return std::sqrt(m_tree->boxes.squared_distance(pointOf(p)));
}

ClosestPoint::Nearest ClosestPoint::nearest(const Eigen::Vector3d& p) const {
    const auto [point, triangle] = m_tree->boxes.closest_point_and_primitive(pointOf(p));
    const auto at = static_cast<std::size_t>(triangle - m_tree->triangles.cbegin());
    return {m_tree->faces[at], {point.x(), point.y(), point.z()}};
}

bool ClosestPoint::meets(const IndexedMesh& other, const Eigen::Vector3d& shift) const {
    for (int f = 0; f < other.faceCount(); ++f) {
        const Triangle triangle(pointOf(other.corner(f, 0) + shift), pointOf(other.corner(f, 1) + shift),
                                pointOf(other.corner(f, 2) + shift));
        if (!triangle.is_degenerate() && m_tree->boxes.do_intersect(triangle))
            return true;
    }
    return false;
}

bool ClosestPoint::holds(const Eigen::Vector3d& p) const {
    // Askew to everything that a mold is made of, so that no ray runs along an edge.
    const Kernel::Ray_3 ray(pointOf(p), Kernel::Vector_3(0.3127, 0.1689, 0.9347));
    return m_tree->boxes.number_of_intersected_primitives(ray) % 2 == 1;
}

} // namespace moldwright

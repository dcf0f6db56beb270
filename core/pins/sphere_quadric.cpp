// SPDX-License-Identifier: AGPL-3.0-or-later
#include "pins/sphere_quadric.h"

#include "castability/mold_state.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr double kRimWeight = 0.01; ///< of the planes at rims and ends, before the stability ratio

/// A medial axis and the triangles at its edges.
class RimFinder {
public:
    explicit RimFinder(const MedialMesh& axis)
        : m_axis(axis), m_triangles(axis.edges.size(), 0), m_third(axis.edges.size(), -1) {
        for (const auto& [a, b, c] : axis.triangles) {
            count(a, b, c);
            count(b, c, a);
            count(c, a, b);
        }
    }

    [[nodiscard]] int trianglesAt(std::size_t edge) const { return m_triangles[edge]; }
    /// The third ball of a triangle at an edge that has one.
    [[nodiscard]] int third(std::size_t edge) const { return m_third[edge]; }

private:
    void count(int a, int b, int third) {
        const std::array<int, 2> edge{std::min(a, b), std::max(a, b)};
        const auto at = std::lower_bound(m_axis.edges.begin(), m_axis.edges.end(), edge);
        const auto e = static_cast<std::size_t>(at - m_axis.edges.begin());
        ++m_triangles[e];
        m_third[e] = third;
    }

    const MedialMesh& m_axis;
    std::vector<int> m_triangles;
    std::vector<int> m_third;
};

class Collector {
public:
    explicit Collector(const MedialMesh& axis) : m_axis(axis), m_quadrics(axis.balls.size()) {}

    /// Both planes that touch all balls of a triangle; none where one ball holds the others.
    void addSlab(const std::array<int, 3>& t) {
        const MedialBall& first = ball(t[0]);
        const Eigen::Vector3d e1 = ball(t[1]).centre - first.centre;
        const Eigen::Vector3d e2 = ball(t[2]).centre - first.centre;
        const Eigen::Vector3d normal = e1.cross(e2);
        const double square = normal.squaredNorm();
        if (!(square > 0))
            return;
        // The gradient of the radius in the triangle's plane.
        const Eigen::Vector3d g = ((ball(t[1]).radius - first.radius) * e2.cross(normal) +
                                   (ball(t[2]).radius - first.radius) * normal.cross(e1)) /
                                  square;
        const double steep = g.squaredNorm();
        if (!(steep < 1))
            return;
        const Eigen::Vector3d up = std::sqrt(1 - steep) * normal / std::sqrt(square);
        for (const int v : t) {
            add(v, up - g, t[0], 1);
            add(v, -up - g, t[0], 1);
        }
    }

    /// Keeps a rim from shrinking into its triangle.
    void addRim(const std::array<int, 2>& edge, int third) {
        const Eigen::Vector3d a = ball(edge[0]).centre;
        const Eigen::Vector3d along = (ball(edge[1]).centre - a).normalized();
        const Eigen::Vector3d in = ball(third).centre - a;
        const Eigen::Vector3d out = (in.dot(along) * along - in).normalized();
        if (!out.allFinite())
            return;
        for (const int v : edge)
            add(v, out, v, rimWeight(edge));
    }

    /// Four planes that touch the cone between two balls, and at free ends one across.
    void addCone(const std::array<int, 2>& edge, bool firstIsEnd, bool secondIsEnd) {
        const Eigen::Vector3d across = ball(edge[1]).centre - ball(edge[0]).centre;
        const double length = across.norm();
        const double slope = (ball(edge[1]).radius - ball(edge[0]).radius) / length;
        if (!(std::abs(slope) < 1))
            return;
        const Eigen::Vector3d axis = across / length;
        const double steep = std::sqrt(1 - slope * slope);
        for (const Eigen::Vector3d& side : planeAxes(axis))
            for (const int v : edge) {
                add(v, steep * side - slope * axis, edge[0], 1);
                add(v, -steep * side - slope * axis, edge[0], 1);
            }
        if (firstIsEnd)
            add(edge[0], -axis, edge[0], rimWeight(edge));
        if (secondIsEnd)
            add(edge[1], axis, edge[1], rimWeight(edge));
    }

    [[nodiscard]] std::vector<SphereQuadric> take() { return std::move(m_quadrics); }

private:
    [[nodiscard]] const MedialBall& ball(int i) const { return m_axis.balls[static_cast<std::size_t>(i)]; }
    [[nodiscard]] double rimWeight(const std::array<int, 2>& edge) const {
        const double ratio = stabilityRatio(sphereOf(ball(edge[0])), sphereOf(ball(edge[1])));
        return kRimWeight * ratio * ratio;
    }
    void add(int v, const Eigen::Vector3d& n, int touching, double weight) {
        m_quadrics[static_cast<std::size_t>(v)].add(n, sphereOf(ball(touching)), weight);
    }

    const MedialMesh& m_axis;
    std::vector<SphereQuadric> m_quadrics;
};

} // namespace

void SphereQuadric::add(const Eigen::Vector3d& n, const Sphere& touching, double weight) {
    const Eigen::Vector4d normal(n.x(), n.y(), n.z(), 1);
    const double level = normal.dot(touching);
    A += weight * normal * normal.transpose();
    b += weight * level * normal;
    c += weight * level * level;
}

SphereQuadric& SphereQuadric::operator+=(const SphereQuadric& o) {
    A += o.A;
    b += o.b;
    c += o.c;
    return *this;
}

double stabilityRatio(const Sphere& u, const Sphere& v) {
    const double distance = (u - v).head<3>().norm();
    return distance > 0 ? std::max(0.0, distance - std::abs(u[3] - v[3])) / distance : 0;
}

std::vector<SphereQuadric> sphereQuadrics(const MedialMesh& axis) {
    const RimFinder rims(axis);
    std::vector<int> degree(axis.balls.size(), 0);
    for (const auto& edge : axis.edges)
        for (const int v : edge)
            ++degree[static_cast<std::size_t>(v)];
    Collector collector(axis);
    for (const auto& triangle : axis.triangles)
        collector.addSlab(triangle);
    for (std::size_t e = 0; e < axis.edges.size(); ++e) {
        const auto& edge = axis.edges[e];
        if (rims.trianglesAt(e) == 1)
            collector.addRim(edge, rims.third(e));
        else if (rims.trianglesAt(e) == 0)
            collector.addCone(edge, degree[static_cast<std::size_t>(edge[0])] == 1,
                              degree[static_cast<std::size_t>(edge[1])] == 1);
    }
    return collector.take();
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "known_axes.h"

#include "mesh/measures.h"
#include "pins/cgal/inside_test.h"
#include "pins/medial_axis.h"
#include "pins/simplify.h"
#include "pins/surface_samples.h"
#include "support/shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace moldwright::test {

namespace {

/// The cone between two balls: along it the nearest ball is where the way to p leans as the radius grows.
double distanceFromCone(const MedialBall& a, const MedialBall& b, const Eigen::Vector3d& p) {
    const Eigen::Vector3d axis = b.centre - a.centre;
    const double length = axis.norm();
    const double slope = (b.radius - a.radius) / length;
    if (!(std::abs(slope) < 1))
        return std::numeric_limits<double>::infinity(); // one ball holds the other
    const Eigen::Vector3d way = p - a.centre;
    const double along = way.dot(axis) / length;
    const double off = std::sqrt(std::max(0.0, way.squaredNorm() - along * along));
    const double t = std::clamp((along + off * slope / std::sqrt(1 - slope * slope)) / length, 0.0, 1.0);
    return (p - a.centre - t * axis).norm() - (a.radius + t * (b.radius - a.radius));
}

/// Between both planes that touch three balls, where the nearest ball lies inside the triangle.
double distanceFromSlab(const MedialBall& a, const MedialBall& b, const MedialBall& c,
                        const Eigen::Vector3d& p) {
    constexpr double none = std::numeric_limits<double>::infinity();
    Eigen::Matrix<double, 3, 2> edges;
    edges << b.centre - a.centre, c.centre - a.centre;
    const Eigen::Vector3d normal = edges.col(0).cross(edges.col(1)).normalized();
    const Eigen::Matrix2d metric = edges.transpose() * edges;
    const Eigen::Vector3d g =
        edges * metric.inverse() * Eigen::Vector2d(b.radius - a.radius, c.radius - a.radius);
    if (!normal.allFinite() || !(g.norm() < 1))
        return none;
    const double height = std::abs(normal.dot(p - a.centre));
    const Eigen::Vector3d nearest = p + height * g / std::sqrt(1 - g.squaredNorm());
    const Eigen::Vector2d uv = metric.inverse() * edges.transpose() * (nearest - a.centre);
    if (uv.minCoeff() < 0 || uv.sum() > 1)
        return none;
    return height * std::sqrt(1 - g.squaredNorm()) - (a.radius + g.dot(p - a.centre));
}

MedialMesh scaled(MedialMesh axis, double factor) {
    for (MedialBall& ball : axis.balls)
        ball = {factor * ball.centre, factor * ball.radius};
    return axis;
}

} // namespace

IndexedMesh capsule(double radius, double half, int around, int along) {
    // Rings from the lower pole to the upper one: a quarter of the circle, the side, a quarter.
    const int quarter = around / 4;
    std::vector<Eigen::Vector2d> profile;
    for (int i = 1; i < quarter; ++i) {
        const double a = std::numbers::pi / 2 * i / quarter;
        profile.emplace_back(radius * std::sin(a), -half - radius * std::cos(a));
    }
    for (int i = 0; i <= along; ++i)
        profile.emplace_back(radius, -half + 2 * half * i / along);
    for (int i = quarter - 1; i > 0; --i) {
        const double a = std::numbers::pi / 2 * i / quarter;
        profile.emplace_back(radius * std::sin(a), half + radius * std::cos(a));
    }
    const int rings = static_cast<int>(profile.size());
    IndexedMesh mesh;
    mesh.V.resize(rings * around + 2, 3);
    mesh.F.resize(2 * rings * around, 3);
    const auto at = [&](int ring, int i) { return ring * around + i % around; };
    for (int ring = 0; ring < rings; ++ring)
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * std::numbers::pi * i / around;
            const Eigen::Vector2d& p = profile[static_cast<std::size_t>(ring)];
            mesh.V.row(at(ring, i)) << p.x() * std::cos(angle), p.x() * std::sin(angle), p.y();
        }
    const int bottom = rings * around;
    mesh.V.row(bottom) << 0, 0, -half - radius;
    mesh.V.row(bottom + 1) << 0, 0, half + radius;
    int f = 0;
    for (int i = 0; i < around; ++i) {
        mesh.F.row(f++) << bottom, at(0, i + 1), at(0, i);
        mesh.F.row(f++) << bottom + 1, at(rings - 1, i), at(rings - 1, i + 1);
        for (int ring = 0; ring + 1 < rings; ++ring) {
            mesh.F.row(f++) << at(ring, i), at(ring, i + 1), at(ring + 1, i + 1);
            mesh.F.row(f++) << at(ring, i), at(ring + 1, i + 1), at(ring + 1, i);
        }
    }
    return mesh;
}

IndexedMesh ellipsoid(double a, double b, double c, int rounds) {
    IndexedMesh mesh = sphere({0, 0, 0}, 1, rounds);
    mesh.V = mesh.V * Eigen::Vector3d(a, b, c).asDiagonal();
    return mesh;
}

double distanceFrom(const MedialMesh& axis, const Eigen::Vector3d& p) {
    const auto ball = [&](int i) -> const MedialBall& { return axis.balls[static_cast<std::size_t>(i)]; };
    double nearest = std::numeric_limits<double>::infinity();
    for (const MedialBall& b : axis.balls)
        nearest = std::min(nearest, (p - b.centre).norm() - b.radius);
    for (const auto& [a, b] : axis.edges)
        nearest = std::min(nearest, distanceFromCone(ball(a), ball(b), p));
    for (const auto& [a, b, c] : axis.triangles)
        nearest = std::min(nearest, distanceFromSlab(ball(a), ball(b), ball(c), p));
    return nearest;
}

Miss missOf(const MedialMesh& axis, const Points& points) {
    Miss miss;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const double distance = distanceFrom(axis, points.row(i).transpose());
        miss.outside = std::max(miss.outside, distance);
        miss.inside = std::max(miss.inside, -distance);
    }
    return miss;
}

MedialMesh wholeAxis(const IndexedMesh& mesh, unsigned seed) {
    const double size = diagonal(mesh);
    const IndexedMesh unit{mesh.V / size, mesh.F};
    return scaled(medialAxis(surfaceSamples(unit, 4e-6, seed), InsideTest(unit), {}), size);
}

MedialMesh reducedAxis(const IndexedMesh& mesh, int count, unsigned seed) {
    const double size = diagonal(mesh);
    return scaled(simplify(scaled(wholeAxis(mesh, seed), 1 / size), count, {}), size);
}

std::vector<int> degrees(const MedialMesh& axis) {
    std::vector<int> degrees(axis.balls.size(), 0);
    for (const auto& edge : axis.edges)
        for (const int v : edge)
            ++degrees[static_cast<std::size_t>(v)];
    return degrees;
}

} // namespace moldwright::test

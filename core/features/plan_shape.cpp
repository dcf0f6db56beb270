// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/plan_shape.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <numbers>

namespace moldwright {

namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

double distanceToSegment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
    const Vector2d along = b - a;
    const double length = along.squaredNorm();
    const double t = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
    return (p - a - t * along).norm();
}

bool segmentsCross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
    return cross(b - a, c - a) * cross(b - a, d - a) < 0 && cross(d - c, a - c) * cross(d - c, b - c) < 0;
}

/// Of the outline of a polygon from a segment; 0 where they cross. Of the segment's ends only the first is
/// measured: the second is the next one's.
double distanceToEdge(const PlanShape& a, const Vector2d& from, const Vector2d& to) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Vector2d& next = a[(i + 1) % a.size()];
        if (segmentsCross(a[i], next, from, to))
            return 0;
        least = std::min({least, distanceToSegment(a[i], from, to), distanceToSegment(from, a[i], next)});
    }
    return least;
}

/// Where the lines of two walls meet, `inset` mm within their feet.
Vector2d insetCorner(const Vector2d& corner, const Vector2d& m0, double inset0, const Vector2d& m1,
                     double inset1) {
    const double turn = m0.x() * m1.y() - m0.y() * m1.x();
    constexpr double straight = 1e-6;
    if (std::abs(turn) < straight)
        return corner - m0 * (inset0 + inset1) / 2;
    return corner - Vector2d(inset0 * m1.y() - inset1 * m0.y(), inset1 * m0.x() - inset0 * m1.x()) / turn;
}

} // namespace

PlanShape planHull(const Points& V) {
    std::vector<Vector2d> points;
    points.reserve(static_cast<std::size_t>(V.rows()));
    for (const auto& p : V.rowwise())
        points.emplace_back(p.head<2>());
    std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    });
    // Lower chain, then the upper one back again.
    PlanShape hull;
    const auto chain = [&](auto begin, auto end) {
        const std::size_t start = hull.size();
        for (auto p = begin; p != end; ++p) {
            while (hull.size() >= start + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0)
                hull.pop_back();
            hull.push_back(*p);
        }
        hull.pop_back();
    };
    chain(points.begin(), points.end());
    chain(points.rbegin(), points.rend());
    return hull;
}

double planDistance(const PlanShape& a, const PlanShape& b) {
    if (insidePlan(a, b.front()) || insidePlan(b, a.front()))
        return 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < b.size() && least > 0; ++j)
        least = std::min(least, distanceToEdge(a, b[j], b[(j + 1) % b.size()]));
    return least;
}

double planDistanceTo(const PlanShape& shape, const Vector2d& p) {
    if (insidePlan(shape, p))
        return 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < shape.size(); ++k)
        least = std::min(least, distanceToSegment(p, shape[k], shape[(k + 1) % shape.size()]));
    return least;
}

bool planKeepsClear(const PlanShape& a, const PlanShape& b, double distance) {
    Eigen::AlignedBox2d boxA;
    Eigen::AlignedBox2d boxB;
    for (const Vector2d& p : a)
        boxA.extend(p);
    for (const Vector2d& p : b)
        boxB.extend(p);
    if (boxA.exteriorDistance(boxB) >= distance)
        return true;
    if (insidePlan(a, b.front()) || insidePlan(b, a.front()))
        return false;
    for (std::size_t j = 0; j < b.size(); ++j) {
        const Vector2d& to = b[(j + 1) % b.size()];
        const Eigen::AlignedBox2d edge(b[j].cwiseMin(to), b[j].cwiseMax(to));
        if (boxA.exteriorDistance(edge) < distance && distanceToEdge(a, b[j], to) < distance)
            return false;
    }
    return true;
}

bool insidePlan(const PlanShape& shape, const Vector2d& p) {
    bool inside = false;
    for (std::size_t i = 0; i < shape.size(); ++i) {
        const Vector2d& a = shape[i];
        const Vector2d& b = shape[(i + 1) % shape.size()];
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            inside = !inside;
    }
    return inside;
}

PlanShape movedPlan(PlanShape shape, const Vector2d& by) {
    for (Vector2d& p : shape)
        p += by;
    return shape;
}

PlanShape planCircle(const Vector2d& centre, double radius, int corners) {
    PlanShape circle;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * (k + 0.5) / corners;
        circle.emplace_back(centre + radius * Vector2d(std::cos(angle), std::sin(angle)));
    }
    return circle;
}

PlanShape planRectangle(const Vector2d& low, const Vector2d& high) {
    return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

Vector2d outwardNormal(const PlanShape& shape, std::size_t edge) {
    const Vector2d along = (shape[(edge + 1) % shape.size()] - shape[edge]).normalized();
    return {along.y(), -along.x()};
}

PlanShape insetShape(const PlanShape& shape, const std::vector<double>& insets) {
    PlanShape inset;
    for (std::size_t k = 0; k < shape.size(); ++k) {
        const std::size_t before = (k + shape.size() - 1) % shape.size();
        inset.push_back(insetCorner(shape[k], outwardNormal(shape, before), insets[before],
                                    outwardNormal(shape, k), insets[k]));
    }
    return inset;
}

} // namespace moldwright

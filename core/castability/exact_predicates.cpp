// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/exact_predicates.h"

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace moldwright {

namespace {

using Eigen::Vector3d;

constexpr double u = std::numeric_limits<double>::epsilon() / 2;
// Below this, products may have underflowed and the bounds below say nothing.
constexpr double tooSmall = 1e-250;

/// A cross product in doubles and what bounds its error: |error_k| ≤ 5u · size_k. Each difference carries a
/// relative error u, each product three of them, the subtraction one more.
struct BoundedCross {
    Vector3d value;
    Vector3d size;
};

BoundedCross boundedCross(const Vector3d& e, const Vector3d& f) {
    BoundedCross cross;
    for (int k = 0; k < 3; ++k) {
        const double p = e[(k + 1) % 3] * f[(k + 2) % 3];
        const double q = e[(k + 2) % 3] * f[(k + 1) % 3];
        cross.value[k] = p - q;
        cross.size[k] = std::abs(p) + std::abs(q);
    }
    return cross;
}

using Rational3 = std::array<mpq_class, 3>;

Rational3 exactDifference(const Vector3d& p, const Vector3d& q) {
    return {mpq_class(q[0]) - mpq_class(p[0]), mpq_class(q[1]) - mpq_class(p[1]),
            mpq_class(q[2]) - mpq_class(p[2])};
}

Rational3 exactCross(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const Rational3 e = exactDifference(a, b);
    const Rational3 f = exactDifference(a, c);
    return {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
}

mpq_class exactDot(const Rational3& c, const Vector3d& d) {
    return c[0] * mpq_class(d[0]) + c[1] * mpq_class(d[1]) + c[2] * mpq_class(d[2]);
}

bool leavesAlongExactly(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d,
                        double tau) {
    const Rational3 cross = exactCross(a, b, c);
    const mpq_class towards = exactDot(cross, d);
    if (sgn(towards) <= 0)
        return false;
    const mpq_class crossSquared = cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2];
    mpq_class directionSquared = 0;
    for (int k = 0; k < 3; ++k)
        directionSquared += mpq_class(d[k]) * mpq_class(d[k]);
    return towards * towards >= mpq_class(tau) * mpq_class(tau) * crossSquared * directionSquared;
}

/// The coordinate that the view against d leaves out, and the two that it shows, right-handed for the viewer.
struct ViewAxes {
    int along = 2;
    double sign = 1; ///< of d[along]
    std::array<int, 2> shown = {0, 1};
};

ViewAxes viewAxes(const Vector3d& d) {
    ViewAxes axes;
    d.cwiseAbs().maxCoeff(&axes.along);
    axes.sign = d[axes.along] > 0 ? 1 : -1;
    axes.shown = {(axes.along + 1) % 3, (axes.along + 2) % 3};
    if (axes.sign < 0)
        std::swap(axes.shown[0], axes.shown[1]);
    return axes;
}

} // namespace

int turnAlong(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
    const BoundedCross cross = boundedCross(b - a, c - a);
    const double towards = cross.value.dot(d);
    const double size = cross.size.dot(d.cwiseAbs());
    if (size > tooSmall && std::abs(towards) > 16 * u * size)
        return towards > 0 ? 1 : -1;
    return sgn(exactDot(exactCross(a, b, c), d));
}

int compareAlong(const Vector3d& p, const Vector3d& q, const Vector3d& d, int axis) {
    // x − (d_x/d_along)·x_along, times |d_along|: constant along d, and no division.
    const ViewAxes axes = viewAxes(d);
    const int shown = axes.shown[static_cast<std::size_t>(axis)];
    const double first = (q[shown] - p[shown]) * d[axes.along];
    const double second = (q[axes.along] - p[axes.along]) * d[shown];
    const double size = std::abs(first) + std::abs(second);
    if (size > tooSmall && std::abs(first - second) > 8 * u * size)
        return (first - second) * axes.sign > 0 ? 1 : -1;
    const Rational3 way = exactDifference(p, q);
    const mpq_class exact = way[static_cast<std::size_t>(shown)] * mpq_class(d[axes.along]) -
                            way[static_cast<std::size_t>(axes.along)] * mpq_class(d[shown]);
    return sgn(exact) * static_cast<int>(axes.sign);
}

Eigen::Vector2d positionAlong(const Vector3d& p, const Vector3d& d) {
    const ViewAxes axes = viewAxes(d);
    Eigen::Vector2d position;
    for (int axis = 0; axis < 2; ++axis) {
        const int shown = axes.shown[static_cast<std::size_t>(axis)];
        position[axis] = axes.sign * (p[shown] * d[axes.along] - p[axes.along] * d[shown]);
    }
    return position;
}

bool leavesAlong(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d, double tau) {
    const BoundedCross cross = boundedCross(b - a, c - a);
    const double towards = cross.value.dot(d);
    const double towardsError = 16 * u * cross.size.dot(d.cwiseAbs());
    const double needed = tau * cross.value.norm() * d.norm();
    const double neededError = 16 * u * tau * cross.size.norm() * d.norm();
    if (cross.size.dot(d.cwiseAbs()) > tooSmall) {
        if (towards - towardsError > 0 && towards - towardsError > needed + neededError)
            return true;
        if (towards + towardsError < 0 || towards + towardsError < needed - neededError)
            return false;
    }
    return leavesAlongExactly(a, b, c, d, tau);
}

Vector3d accurateAreaVector(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const BoundedCross cross = boundedCross(b - a, c - a);
    if (cross.size.norm() > tooSmall && cross.value.norm() > 1e-3 * cross.size.norm())
        return cross.value;
    const Rational3 exact = exactCross(a, b, c);
    return {exact[0].get_d(), exact[1].get_d(), exact[2].get_d()};
}

} // namespace moldwright

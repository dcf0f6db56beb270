// SPDX-License-Identifier: AGPL-3.0-or-later
#include "field.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace moldwright::samples {

namespace {

Eigen::Matrix3d rotation(const Vector3d& turn) {
    return (Eigen::AngleAxisd(turn.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(turn.y(), Vector3d::UnitY()) *
            Eigen::AngleAxisd(turn.x(), Vector3d::UnitX()))
        .toRotationMatrix();
}

} // namespace

Vector3d gradient(const Field& field, const Vector3d& p, double step) {
    Vector3d g;
    for (int k = 0; k < 3; ++k) {
        const Vector3d e = step * Vector3d::Unit(k);
        g[k] = (field(p + e) - field(p - e)) / (2 * step);
    }
    return g;
}

Taylor expand(const Field& field, const Vector3d& p, double step) {
    Taylor t;
    t.value = field(p);
    std::array<double, 3> sum{}; // of the values on both sides
    for (int k = 0; k < 3; ++k) {
        const Vector3d e = step * Vector3d::Unit(k);
        const double ahead = field(p + e);
        const double behind = field(p - e);
        sum[k] = ahead + behind;
        t.gradient[k] = (ahead - behind) / (2 * step);
        t.hessian(k, k) = (sum[k] - 2 * t.value) / (step * step);
    }
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < i; ++j) {
            const Vector3d e = step * (Vector3d::Unit(i) + Vector3d::Unit(j));
            t.hessian(i, j) =
                (field(p + e) + field(p - e) - sum[i] - sum[j] + 2 * t.value) / (2 * step * step);
            t.hessian(j, i) = t.hessian(i, j);
        }
    return t;
}

Field ball(const Vector3d& centre, double radius) {
    return [=](const Vector3d& p) { return (p - centre).norm() - radius; };
}

double ellipticDistance(const Vector3d& q, const Vector3d& radii) {
    const double k0 = q.cwiseQuotient(radii).norm();
    const double k1 = q.cwiseQuotient(radii.cwiseAbs2()).norm();
    return k1 > 1e-12 ? k0 * (k0 - 1) / k1 : -radii.minCoeff();
}

Field ellipsoid(const Vector3d& centre, const Vector3d& radii, const Vector3d& turn) {
    const Eigen::Matrix3d toLocal = rotation(turn).transpose();
    return [=](const Vector3d& p) { return ellipticDistance(toLocal * (p - centre), radii); };
}

Field roundedBox(const Vector3d& centre, const Vector3d& half, double rounding) {
    return [=](const Vector3d& p) {
        const Vector3d q = (p - centre).cwiseAbs() - half + Vector3d::Constant(rounding);
        return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0) - rounding;
    };
}

double smoothMin(double a, double b, double blend) {
    const double h = std::max(blend - std::abs(a - b), 0.0);
    return h > 0 ? std::min(a, b) - h * h * h / (6 * blend * blend) : std::min(a, b);
}

Field join(std::vector<Field> solids, double blend) {
    return [solids = std::move(solids), blend](const Vector3d& p) {
        double d = solids.front()(p);
        for (std::size_t k = 1; k < solids.size(); ++k)
            d = smoothMin(d, solids[k](p), blend);
        return d;
    };
}

Field carve(Field solid, Field tool, double blend) {
    return [solid = std::move(solid), tool = std::move(tool), blend](const Vector3d& p) {
        return -smoothMin(-solid(p), tool(p), blend);
    };
}

Field overlap(Field a, Field b, double blend) {
    return [a = std::move(a), b = std::move(b), blend](const Vector3d& p) {
        return -smoothMin(-a(p), -b(p), blend);
    };
}

Field turned(Field solid, const Vector3d& turn, const Vector3d& pivot) {
    return [solid = std::move(solid), back = Eigen::Matrix3d(rotation(turn).transpose()),
            pivot](const Vector3d& p) { return solid(pivot + back * (p - pivot)); };
}

Field moved(Field solid, const Vector3d& offset) {
    return [solid = std::move(solid), offset](const Vector3d& p) { return solid(p - offset); };
}

Field mirrored(Field solid) {
    return [solid = std::move(solid)](const Vector3d& p) { return solid(Vector3d(-p.x(), p.y(), p.z())); };
}

} // namespace moldwright::samples

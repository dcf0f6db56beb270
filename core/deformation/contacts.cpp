// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/contacts.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace moldwright {

namespace {

using Eigen::Vector3d;

constexpr double kNearerThanAtRest = 0.5; ///< else thin walls would be pushed apart through themselves

int surfacePoints(const BodyShape& body) {
    return body.F.size() ? body.F.maxCoeff() + 1 : 0;
}

/// Of each surface point, by the area of its faces.
Positions normals(const BodyShape& body, const Positions& X) {
    Positions N = Positions::Zero(surfacePoints(body), 3);
    for (Eigen::Index f = 0; f < body.F.rows(); ++f) {
        const Vector3d a = X.row(body.F(f, 0));
        const Vector3d b = X.row(body.F(f, 1));
        const Vector3d c = X.row(body.F(f, 2));
        const Vector3d area = (b - a).cross(c - a);
        for (int k = 0; k < 3; ++k)
            N.row(body.F(f, k)) += area.transpose();
    }
    N.rowwise().normalize();
    return N;
}

/// Points in cubes as wide as the reach: those near a place lie in 27 of them.
class Cubes {
public:
    Cubes(const Positions& X, int points, double width) : m_width(width) {
        for (int v = 0; v < points; ++v)
            m_points[key(cube(X.row(v)))].push_back(v);
    }

    template <class Visit>
    void near(const Vector3d& place, const Visit& visit) const {
        const std::array<std::int64_t, 3> middle = cube(place);
        for (int i = 0; i < 27; ++i)
            if (const auto found = m_points.find(
                    key({middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1}));
                found != m_points.end())
                for (const int v : found->second)
                    visit(v);
    }

private:
    [[nodiscard]] std::array<std::int64_t, 3> cube(const Vector3d& x) const {
        return {static_cast<std::int64_t>(std::floor(x.x() / m_width)),
                static_cast<std::int64_t>(std::floor(x.y() / m_width)),
                static_cast<std::int64_t>(std::floor(x.z() / m_width))};
    }
    static std::uint64_t key(const std::array<std::int64_t, 3>& c) {
        constexpr std::uint64_t mask = (1U << 21U) - 1;
        const auto part = [](std::int64_t n) { return static_cast<std::uint64_t>(n) & mask; };
        return part(c[0]) | part(c[1]) << 21U | part(c[2]) << 42U;
    }

    double m_width;
    std::unordered_map<std::uint64_t, std::vector<int>> m_points;
};

} // namespace

double meanEdge(const BodyShape& body) {
    double sum = 0;
    for (Eigen::Index f = 0; f < body.F.rows(); ++f)
        for (int k = 0; k < 3; ++k)
            sum += (body.V.row(body.F(f, k)) - body.V.row(body.F(f, (k + 1) % 3))).norm();
    return sum / static_cast<double>(std::max<Eigen::Index>(1, 3 * body.F.rows()));
}

std::vector<Contact> contactsAt(const BodyShape& body, const Positions& X, double gap) {
    const int points = surfacePoints(body);
    const Positions N = normals(body, X);
    const Cubes cubes(X, points, gap);
    std::vector<Contact> contacts;
    for (int a = 0; a < points; ++a) {
        int nearest = -1;
        double distance = gap;
        cubes.near(X.row(a), [&](int b) {
            const double now = (X.row(a) - X.row(b)).norm();
            if (now < distance && N.row(a).dot(N.row(b)) < 0 &&
                now < kNearerThanAtRest * (body.V.row(a) - body.V.row(b)).norm()) {
                nearest = b;
                distance = now;
            }
        });
        if (nearest >= 0)
            contacts.push_back({a, nearest, (N.row(nearest) - N.row(a)).normalized().transpose(), gap});
    }
    return contacts;
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/polygon_soup.h"

#include "mesh/point_rows.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace moldwright {

namespace {

using Triangle = std::array<int, 3>;

double doubleArea(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// The polygon seen along its normal, so that it runs counter-clockwise, at a size where areas neither vanish
/// nor overflow.
std::vector<Eigen::Vector2d> flattened(const std::vector<Eigen::Vector3d>& points,
                                       std::span<const int> ring) {
    std::vector<Eigen::Vector3d> local;
    double size = 0;
    for (const int v : ring) {
        local.emplace_back(points[static_cast<std::size_t>(v)] - points[static_cast<std::size_t>(ring[0])]);
        size = std::max(size, local.back().cwiseAbs().maxCoeff());
    }
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < local.size(); ++i) {
        local[i] /= size > 0 ? size : 1;
        normal += local[i > 0 ? i - 1 : 0].cross(local[i]);
    }
    normal = normal.norm() > 0 ? normal.normalized().eval() : Eigen::Vector3d::UnitZ().eval();
    const Eigen::Vector3d across = normal.unitOrthogonal();
    const Eigen::Vector3d up = normal.cross(across);
    std::vector<Eigen::Vector2d> flat;
    flat.reserve(local.size());
    for (const Eigen::Vector3d& p : local)
        flat.emplace_back(across.dot(p), up.dot(p));
    return flat;
}

/// Cuts one polygon into triangles of places in its ring. How good each corner is as an ear is kept and
/// renewed only beside the corner that was cut, so that the whole takes quadratic time.
class EarClipping {
public:
    explicit EarClipping(std::vector<Eigen::Vector2d> flat) : m_flat(std::move(flat)) {
        const int n = static_cast<int>(m_flat.size());
        for (int i = 0; i < n; ++i)
            m_ring.push_back(i);
        for (int k = 0; k < n; ++k)
            m_quality.push_back(quality(k));
    }

    std::vector<Triangle> run() {
        std::vector<Triangle> triangles;
        while (m_ring.size() > 3) {
            const int k =
                static_cast<int>(std::max_element(m_quality.begin(), m_quality.end()) - m_quality.begin());
            triangles.push_back({at(k - 1), at(k), at(k + 1)});
            m_ring.erase(m_ring.begin() + k);
            m_quality.erase(m_quality.begin() + k);
            for (const int beside : {k - 1, k})
                m_quality[wrapped(beside)] = quality(beside);
        }
        triangles.push_back({at(0), at(1), at(2)});
        return triangles;
    }

private:
    [[nodiscard]] std::size_t wrapped(int k) const {
        const int n = static_cast<int>(m_ring.size());
        return static_cast<std::size_t>((k + n) % n);
    }
    [[nodiscard]] int at(int k) const { return m_ring[wrapped(k)]; }
    [[nodiscard]] const Eigen::Vector2d& point(int k) const {
        return m_flat[static_cast<std::size_t>(at(k))];
    }

    /// Area over squared perimeter of the ear at corner k; negative when the corner is hollow, less than that
    /// when other corners lie inside the ear.
    [[nodiscard]] double quality(int k) const {
        const Eigen::Vector2d& a = point(k - 1);
        const Eigen::Vector2d& b = point(k);
        const Eigen::Vector2d& c = point(k + 1);
        const double perimeter = (b - a).norm() + (c - b).norm() + (a - c).norm();
        const double shape = perimeter > 0 ? doubleArea(a, b, c) / (perimeter * perimeter) : 0;
        if (shape <= 0)
            return shape - 1;
        for (int i = k + 2; i < k - 1 + static_cast<int>(m_ring.size()); ++i) {
            const Eigen::Vector2d& p = point(i);
            const bool isCorner = p == a || p == b || p == c;
            if (!isCorner && doubleArea(a, b, p) >= 0 && doubleArea(b, c, p) >= 0 && doubleArea(c, a, p) >= 0)
                return shape - 2;
        }
        return shape;
    }

    std::vector<Eigen::Vector2d> m_flat;
    std::vector<int> m_ring;
    std::vector<double> m_quality;
};

std::vector<Triangle> triangulatedRing(const std::vector<Eigen::Vector3d>& points,
                                       std::span<const int> ring) {
    if (ring.size() == 3)
        return {{0, 1, 2}};
    return EarClipping(flattened(points, ring)).run();
}

} // namespace

IndexedMesh triangulated(const PolygonSoup& soup) {
    IndexedMesh mesh;
    mesh.V = pointRows(soup.points);
    // A polygon of n corners has n − 2 triangles; corners of one that was never ended make none.
    mesh.F.resize(soup.firstCorner.back() - 2L * soup.polygonCount(), 3);
    Eigen::Index f = 0;
    for (int p = 0; p < soup.polygonCount(); ++p) {
        const std::span<const int> ring = soup.polygon(p);
        for (const Triangle& t : triangulatedRing(soup.points, ring)) {
            for (std::size_t k = 0; k < 3; ++k)
                mesh.F(f, static_cast<Eigen::Index>(k)) = ring[static_cast<std::size_t>(t[k])];
            ++f;
        }
    }
    return mesh;
}

} // namespace moldwright

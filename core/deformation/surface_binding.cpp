// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/surface_binding.h"

#include "base/parallel.h"
#include "mesh/nearest_on_triangle.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <set>

namespace moldwright {

namespace {

constexpr std::size_t kGrain = 256;
constexpr double kNormalWeight = 0.5; ///< of a neighbourhood's normal beside its edges
constexpr double kLeast = 1e-6;       ///< of an edge squared: keeps needles invertible

} // namespace

SurfaceBinding::SurfaceBinding(IndexedMesh coarse, Points fine, const std::vector<int>& seeds)
    : m_coarse(std::move(coarse)), m_fine(std::move(fine)),
      m_ringStart(static_cast<std::size_t>(m_coarse.vertexCount()) + 1, 0),
      m_ring(static_cast<std::size_t>(3 * m_coarse.faceCount())), m_ties(seeds.size()) {
    for (int f = 0; f < m_coarse.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            ++m_ringStart[static_cast<std::size_t>(m_coarse.F(f, k)) + 1];
    for (std::size_t v = 1; v < m_ringStart.size(); ++v)
        m_ringStart[v] += m_ringStart[v - 1];
    std::vector<int> next(m_ringStart.begin(), m_ringStart.end() - 1);
    for (int f = 0; f < m_coarse.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            m_ring[static_cast<std::size_t>(next[static_cast<std::size_t>(m_coarse.F(f, k))]++)] = f;
    parallelFor(seeds.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const auto [face, weights] =
                nearestFrom(m_fine.row(static_cast<Eigen::Index>(v)).transpose(), seeds[v]);
            m_ties[v] = {{m_coarse.F(face, 0), m_coarse.F(face, 1), m_coarse.F(face, 2)}, weights};
        }
    });
}

std::pair<int, Eigen::Vector3d> SurfaceBinding::nearestFrom(const Eigen::Vector3d& p, int seed) const {
    std::pair<int, Eigen::Vector3d> best{-1, Eigen::Vector3d::Zero()};
    double least = std::numeric_limits<double>::infinity();
    std::set<int> seen;
    std::vector<int> around{seed};
    while (!around.empty()) {
        const double before = least;
        for (const int v : around)
            for (int r = m_ringStart[static_cast<std::size_t>(v)];
                 r < m_ringStart[static_cast<std::size_t>(v) + 1]; ++r) {
                const int f = m_ring[static_cast<std::size_t>(r)];
                if (!seen.insert(f).second)
                    continue;
                const Eigen::Vector3d weights =
                    nearestOnTriangle(p, m_coarse.corner(f, 0), m_coarse.corner(f, 1), m_coarse.corner(f, 2));
                const Eigen::Vector3d at = weights[0] * m_coarse.corner(f, 0) +
                                           weights[1] * m_coarse.corner(f, 1) +
                                           weights[2] * m_coarse.corner(f, 2);
                const double square = (p - at).squaredNorm();
                if (square < least) {
                    least = square;
                    best = {f, weights};
                }
            }
        around.clear();
        if (least < before)
            for (int k = 0; k < 3; ++k)
                around.push_back(m_coarse.F(best.first, k));
    }
    return best;
}

/// The affine map of each coarse point's neighbourhood that fits its edges and its normal best.
std::vector<Eigen::Matrix3d> SurfaceBinding::motionsOfPoints(const Points& X) const {
    std::vector<Eigen::Matrix3d> motions(static_cast<std::size_t>(m_coarse.vertexCount()));
    const IndexedMesh now{X, m_coarse.F};
    parallelFor(motions.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            Eigen::Matrix3d rest = Eigen::Matrix3d::Zero();
            Eigen::Matrix3d moved = Eigen::Matrix3d::Zero();
            Eigen::Vector3d restNormal = Eigen::Vector3d::Zero();
            Eigen::Vector3d normal = Eigen::Vector3d::Zero();
            for (int r = m_ringStart[v]; r < m_ringStart[v + 1]; ++r) {
                const int f = m_ring[static_cast<std::size_t>(r)];
                const Eigen::Vector3d a = m_coarse.corner(f, 1) - m_coarse.corner(f, 0);
                const Eigen::Vector3d b = m_coarse.corner(f, 2) - m_coarse.corner(f, 0);
                const Eigen::Vector3d c = now.corner(f, 1) - now.corner(f, 0);
                const Eigen::Vector3d d = now.corner(f, 2) - now.corner(f, 0);
                rest += a * a.transpose() + b * b.transpose() + (b - a) * (b - a).transpose();
                moved += c * a.transpose() + d * b.transpose() + (d - c) * (b - a).transpose();
                restNormal += a.cross(b);
                normal += c.cross(d);
            }
            restNormal.normalize();
            normal.normalize();
            const double size = rest.trace();
            rest += kNormalWeight * size * restNormal * restNormal.transpose();
            moved += kNormalWeight * size * normal * restNormal.transpose();
            rest += kLeast * size * Eigen::Matrix3d::Identity();
            moved += kLeast * size * Eigen::Matrix3d::Identity();
            motions[v] = moved * rest.inverse();
        }
    });
    return motions;
}

Points SurfaceBinding::carry(const Points& X) const {
    const std::vector<Eigen::Matrix3d> motions = motionsOfPoints(X);
    Points carried(m_fine.rows(), 3);
    parallelFor(m_ties.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const Eigen::Vector3d p = m_fine.row(static_cast<Eigen::Index>(v)).transpose();
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            for (int k = 0; k < 3; ++k) {
                const int c = m_ties[v].points[static_cast<std::size_t>(k)];
                sum += m_ties[v].weights[k] * (X.row(c).transpose() + motions[static_cast<std::size_t>(c)] *
                                                                          (p - m_coarse.point(c)));
            }
            carried.row(static_cast<Eigen::Index>(v)) = sum.transpose();
        }
    });
    return carried;
}

} // namespace moldwright

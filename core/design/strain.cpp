// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/strain.h"

#include "base/parallel.h"
#include "mesh/measures.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace moldwright {

namespace {

constexpr double kPercentile = 0.01;
constexpr double kNeedle = 1e-3; ///< height over longest edge below which a face has no shape to speak of

/// A face's edges from its first corner, in a frame of its own plane.
Eigen::Matrix2d edgesInPlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const Eigen::Vector3d x = (b - a).normalized();
    const Eigen::Vector3d up = (b - a).cross(c - a);
    const Eigen::Vector3d y = up.cross(x).normalized();
    Eigen::Matrix2d edges;
    edges << (b - a).norm(), (c - a).dot(x), 0, (c - a).dot(y);
    return edges;
}

/// How face f of `cast` was stretched from its corners' places in `before`: the larger principal stretch
/// first; and its area then.
struct Stretch {
    Eigen::Vector2d sigma = Eigen::Vector2d::Ones();
    double areaBefore = 0;
};

Stretch stretchOf(const std::array<Eigen::Vector3d, 3>& before, const IndexedMesh& cast, int f) {
    const double area = (before[1] - before[0]).cross(before[2] - before[0]).norm() / 2;
    if (!(area > 0))
        return {};
    const Eigen::Matrix2d F = edgesInPlane(cast.corner(f, 0), cast.corner(f, 1), cast.corner(f, 2)) *
                              edgesInPlane(before[0], before[1], before[2]).inverse();
    return {F.jacobiSvd().singularValues(), area};
}

bool isNeedle(const std::array<Eigen::Vector3d, 3>& x) {
    const double longest = std::max({(x[1] - x[0]).norm(), (x[2] - x[1]).norm(), (x[0] - x[2]).norm()});
    return (x[1] - x[0]).cross(x[2] - x[0]).norm() <= kNeedle * longest * longest;
}

/// The value below which `share` of the weight lies.
double percentile(std::vector<std::pair<double, double>> valueAndWeight, double share) {
    if (valueAndWeight.empty())
        return 1;
    std::sort(valueAndWeight.begin(), valueAndWeight.end());
    const double whole = std::accumulate(valueAndWeight.begin(), valueAndWeight.end(), 0.0,
                                         [](double sum, const auto& entry) { return sum + entry.second; });
    double sum = 0;
    for (const auto& [value, weight] : valueAndWeight) {
        sum += weight;
        if (sum >= share * whole)
            return value;
    }
    return valueAndWeight.back().first;
}

/// √(mean of the squared angle between neighbouring faces, weighed by the length of their edge).
double rmsDihedral(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, int> faceAt;
    double sum = 0;
    double length = 0;
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.F(f, k);
            const int b = mesh.F(f, (k + 1) % 3);
            faceAt[{a, b}] = f;
            const auto across = faceAt.find({b, a});
            if (across == faceAt.end())
                continue;
            const Eigen::Vector3d m = doubleAreaVector(mesh, f);
            const Eigen::Vector3d n = doubleAreaVector(mesh, across->second);
            const double angle = std::atan2(m.cross(n).norm(), m.dot(n));
            const double edge = (mesh.point(b) - mesh.point(a)).norm();
            sum += edge * angle * angle;
            length += edge;
        }
    return length > 0 ? std::sqrt(sum / length) : 0;
}

} // namespace

std::vector<double> faceStrains(const Points& before, const IndexedMesh& cast) {
    std::vector<double> strains(static_cast<std::size_t>(cast.faceCount()));
    parallelFor(strains.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            std::array<Eigen::Vector3d, 3> x;
            for (int k = 0; k < 3; ++k)
                x[static_cast<std::size_t>(k)] = before.row(cast.F(static_cast<int>(f), k)).transpose();
            strains[f] = (stretchOf(x, cast, static_cast<int>(f)).sigma.array() - 1).matrix().norm();
        }
    });
    return strains;
}

SurfaceStrain surfaceStrain(const IndexedMesh& before, const IndexedMesh& cast,
                            const std::vector<int>& sourceVertex) {
    std::vector<std::pair<double, double>> low;
    std::vector<std::pair<double, double>> high;
    double squares = 0;
    double whole = 0;
    for (int f = 0; f < cast.faceCount(); ++f) {
        std::array<Eigen::Vector3d, 3> x;
        for (int k = 0; k < 3; ++k)
            x[static_cast<std::size_t>(k)] =
                before.point(sourceVertex[static_cast<std::size_t>(cast.F(f, k))]);
        if (isNeedle(x))
            continue;
        const auto& [sigma, area] = stretchOf(x, cast, f);
        squares += area * (sigma.array() - 1).square().sum();
        whole += area;
        high.emplace_back(sigma[0], area);
        low.emplace_back(sigma[1], area);
    }
    const double rough = rmsDihedral(before);
    return {whole > 0 ? std::sqrt(squares / whole) : 0, percentile(std::move(low), kPercentile),
            percentile(std::move(high), 1 - kPercentile), rough > 0 ? rmsDihedral(cast) / rough : 1};
}

} // namespace moldwright

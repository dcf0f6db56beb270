// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/carried_pins.h"

#include "design/comparison.h"
#include "mesh/closest_point.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace moldwright {

namespace {

constexpr double kOnSurface = 1e-3; ///< of the diagonal: pins no deeper are of the surface
constexpr double kAbout = 1.5;      ///< times its distance from the nearest point: what moves a pin inside
constexpr std::size_t kFewest = 12; ///< points that move a pin inside

/// The points of the surface from the nearest to p on.
std::vector<int> byDistance(const IndexedMesh& part, const Eigen::Vector3d& p) {
    const Eigen::VectorXd away = (part.V.rowwise() - p.transpose()).rowwise().squaredNorm();
    std::vector<int> points(static_cast<std::size_t>(part.vertexCount()));
    std::iota(points.begin(), points.end(), 0);
    std::ranges::stable_sort(points, {}, [&](int v) { return away[v]; });
    return points;
}

Eigen::Vector3d carriedInside(const Eigen::Vector3d& p, const IndexedMesh& part, const IndexedMesh& shape) {
    std::vector<int> about = byDistance(part, p);
    const double reach = kAbout * (part.point(about.front()) - p).norm();
    const auto end = std::ranges::find_if(about, [&](int v) { return (part.point(v) - p).norm() > reach; });
    about.resize(std::min(about.size(), std::max(kFewest, static_cast<std::size_t>(end - about.begin()))));
    return bestRigidFit(part.V(about, Eigen::all), shape.V(about, Eigen::all)) * p;
}

} // namespace

std::vector<Pin> carriedPins(std::vector<Pin> pins, const IndexedMesh& part, const IndexedMesh& shape) {
    if (pins.empty() || &part == &shape)
        return pins;
    const ClosestPoint surface(part);
    const double onSurface = kOnSurface * diagonal(part);
    for (Pin& pin : pins)
        pin.point = surface.distance(pin.point) > onSurface
                        ? carriedInside(pin.point, part, shape)
                        : shape.point(byDistance(part, pin.point).front());
    return pins;
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/flat_back.h"

#include "mesh/measures.h"

#include <algorithm>
#include <numeric>

namespace moldwright {

namespace {

constexpr std::size_t kTries = 400;  ///< largest faces looked at
constexpr double kTolerance = 1e-6;  ///< of the diagonal: still in the plane
constexpr double kLeastShare = 0.01; ///< of the surface

/// Whether no point lies below the plane. Nearly all planes fail at one of the first points.
bool allAbove(const Points& V, const PartingPlane& plane, double tolerance) {
    for (Eigen::Index v = 0; v < V.rows(); ++v)
        if (plane.distance(V.row(v).transpose()) < -tolerance)
            return false;
    return true;
}

} // namespace

std::vector<PartingPlane> flatBackPlanes(const IndexedMesh& mesh) {
    const double tolerance = kTolerance * diagonal(mesh);
    std::vector<double> areas(static_cast<std::size_t>(mesh.faceCount()));
    for (int f = 0; f < mesh.faceCount(); ++f)
        areas[static_cast<std::size_t>(f)] = doubleAreaVector(mesh, f).norm() / 2;
    const double surface = std::accumulate(areas.begin(), areas.end(), 0.0);
    std::vector<int> order(areas.size());
    std::iota(order.begin(), order.end(), 0);
    // A patch of 1 % holds a face of its own mean size at least; a few large ones decide.
    const std::size_t tries = std::min(order.size(), kTries);
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(tries), order.end(),
                      [&](int a, int b) {
                          const double areaA = areas[static_cast<std::size_t>(a)];
                          const double areaB = areas[static_cast<std::size_t>(b)];
                          return areaA != areaB ? areaA > areaB : a < b;
                      });
    std::vector<PartingPlane> planes;
    std::vector<char> used(areas.size(), 0);
    for (std::size_t i = 0; i < tries; ++i) {
        const int seed = order[i];
        if (used[static_cast<std::size_t>(seed)] || !(areas[static_cast<std::size_t>(seed)] > 0))
            continue;
        PartingPlane plane{-doubleAreaVector(mesh, seed).normalized(), 0};
        plane.offset = plane.normal.dot(mesh.corner(seed, 0));
        if (!allAbove(mesh.V, plane, tolerance))
            continue;
        double patch = 0;
        double highest = plane.offset;
        for (int f = 0; f < mesh.faceCount(); ++f) {
            double top = plane.normal.dot(mesh.corner(f, 0));
            for (int k = 1; k < 3; ++k)
                top = std::max(top, plane.normal.dot(mesh.corner(f, k)));
            if (top > plane.offset + tolerance)
                continue;
            used[static_cast<std::size_t>(f)] = 1;
            patch += areas[static_cast<std::size_t>(f)];
            highest = std::max(highest, top);
        }
        // At the highest of the patch's points none of its faces lies on side 1.
        plane.offset = highest;
        if (patch > kLeastShare * surface)
            planes.push_back(plane);
    }
    return planes;
}

} // namespace moldwright

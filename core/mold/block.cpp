// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/block.h"

#include "mesh/measures.h"

#include <cmath>
#include <limits>

namespace moldwright {

namespace {

/// `length` rounded up to a multiple of `step`, as a float.
double roundedUp(double length, double step) {
    const double rounded = step > 0 ? std::ceil(length / step - 1e-9) * step : length;
    return static_cast<float>(rounded);
}

} // namespace

Block blockAround(const IndexedMesh& placedCast, const MoldSettings& settings) {
    const Eigen::AlignedBox3d cast = boundingBox(placedCast);
    const auto halfWidth = [&](int axis) {
        const double reach = std::max(-cast.min()[axis], cast.max()[axis]);
        return static_cast<double>(
            static_cast<float>(roundedUp(2 * (reach + settings.wall), settings.step) / 2));
    };
    const double up = roundedUp(std::max(cast.max().z(), 0.0) + settings.ceiling, settings.step);
    const double down = roundedUp(std::max(-cast.min().z(), 0.0) + settings.floor, settings.step);
    return {Eigen::Vector3d(-halfWidth(0), -halfWidth(1), -down),
            Eigen::Vector3d(halfWidth(0), halfWidth(1), up)};
}

LeastWall leastWall(const IndexedMesh& placedCast, const Block& block) {
    // The block is convex and the cavity's faces are flat: the nearest cavity point is a vertex.
    LeastWall least{std::numeric_limits<double>::infinity(), {}};
    for (int v = 0; v < placedCast.vertexCount(); ++v) {
        const Eigen::Vector3d p = placedCast.point(v);
        const double wall = std::min((p - block.min()).minCoeff(), (block.max() - p).minCoeff());
        if (wall < least.thickness)
            least = {wall, p};
    }
    return least;
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/block.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

/// `length` rounded up to a multiple of `step`, and to one of the grid.
double roundedUp(double length, double step, double grid) {
    const double rounded = step > 0 ? std::ceil(length / step - 1e-9) * step : length;
    return grid > 0 ? std::ceil(rounded / grid - 1e-9) * grid : rounded;
}

} // namespace

Block blockAround(const BlockContent& content, const MoldSettings& settings, double grid) {
    const Eigen::AlignedBox3d& cast = content.cavities;
    const double step = settings.step;
    const auto half = [&](int axis, double wall) {
        const double reach = std::max(-cast.min()[axis], cast.max()[axis]);
        return roundedUp(roundedUp(2 * (reach + wall), step, 0) / 2, 0, grid);
    };
    const double x = half(0, content.wallX);
    const double y = half(1, content.wallY);
    const double top = std::max(y, roundedUp(content.spoutTop, step, grid));
    const double up = roundedUp(std::max(cast.max().z(), 0.0) + settings.ceiling, step, grid);
    const double down = roundedUp(std::max(-cast.min().z(), 0.0) + settings.floor, step, grid);
    return {Eigen::Vector3d(-x, -y, -down), Eigen::Vector3d(x, top, up)};
}

} // namespace moldwright

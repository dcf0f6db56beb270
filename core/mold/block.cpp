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

/// What a length lacks to the next of the stock; none where it is longer than all.
std::optional<double> missingToStock(double length, const std::vector<double>& stock) {
    if (stock.empty())
        return 0;
    std::optional<double> least;
    for (const double has : stock)
        if (has >= length - 1e-9 && (!least || has - length < *least))
            least = std::max(0.0, has - length);
    return least;
}

} // namespace

std::optional<Block> blockAround(const BlockContent& content, const MoldSettings& settings, double grid) {
    const Eigen::AlignedBox3d& cast = content.cavities;
    const double step = settings.step;
    const auto half = [&](int axis, double wall) {
        const double reach = std::max(-cast.min()[axis], cast.max()[axis]);
        return roundedUp(roundedUp(2 * (reach + wall), step, 0) / 2, 0, grid);
    };
    const auto forHand = [&](double reach) {
        return content.byHand.isEmpty() ? 0 : roundedUp(roundedUp(2 * reach, step, 0) / 2, 0, grid);
    };
    const Eigen::AlignedBox2d& byHand = content.byHand;
    const double x =
        std::max({half(0, content.wallX), forHand(-byHand.min().x()), forHand(byHand.max().x())});
    const double y = half(1, content.wallY);
    const double top = std::max({y, roundedUp(content.spoutTop, step, grid), forHand(byHand.max().y())});
    const double bottom = std::max(y, forHand(-byHand.min().y()));
    const double up = roundedUp(std::max(cast.max().z(), 0.0) + settings.ceiling, step, grid);
    const double down = roundedUp(std::max(-cast.min().z(), 0.0) + settings.floor, step, grid);
    Block block(Eigen::Vector3d(-x, -bottom, -down), Eigen::Vector3d(x, top, up));
    for (const int axis : {0, 1}) {
        const std::optional<double> more = missingToStock(block.sizes()[axis], settings.stock);
        if (!more)
            return std::nullopt;
        // On both sides in x, so that the origin stays in the middle; away from the spout's mouth in y.
        block.min()[axis] -= roundedUp(axis == 0 ? *more / 2 : *more, 0, grid);
        block.max()[axis] += axis == 0 ? roundedUp(*more / 2, 0, grid) : 0;
    }
    return block;
}

} // namespace moldwright

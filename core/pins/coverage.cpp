// SPDX-License-Identifier: AGPL-3.0-or-later
#include "pins/coverage.h"

#include "base/parallel.h"

#include <algorithm>
#include <limits>

namespace moldwright {

namespace {

constexpr std::size_t kGrain = 1024;

} // namespace

std::vector<MedialBall> missingBalls(const Points& samples, const MedialMesh& axis,
                                     const std::vector<MedialBall>& chosen, double reach, int most) {
    std::vector<double> off(static_cast<std::size_t>(samples.rows()),
                            std::numeric_limits<double>::infinity());
    const auto sample = [&](std::size_t i) -> Eigen::Vector3d {
        return samples.row(static_cast<Eigen::Index>(i)).transpose();
    };
    const auto take = [&](const std::vector<MedialBall>& balls) {
        parallelFor(off.size(), kGrain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                for (const MedialBall& ball : balls)
                    off[i] = std::min(off[i], distanceFrom(ball, sample(i)));
        });
    };
    take(chosen);
    std::vector<MedialBall> added;
    while (static_cast<int>(added.size()) < most) {
        const auto farthest = std::max_element(off.begin(), off.end());
        if (!(*farthest > reach))
            break;
        const Eigen::Vector3d p = sample(static_cast<std::size_t>(farthest - off.begin()));
        const MedialBall* largest = nullptr;
        for (const MedialBall& ball : axis.balls)
            if (distanceFrom(ball, p) <= reach && (!largest || ball.radius > largest->radius))
                largest = &ball;
        if (!largest) {
            *farthest = 0; // a sample of a piece that was left out
            continue;
        }
        added.push_back(*largest);
        take({*largest});
    }
    return added;
}

} // namespace moldwright

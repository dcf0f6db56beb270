// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/pour_tilt.h"

#include "base/parallel.h"
#include "castability/mold_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace moldwright {

namespace {

using Eigen::Vector3d;

constexpr int ways = 8;
constexpr double eighth = 360.0 / ways;

/// The air of all of these, side by side.
std::vector<std::optional<TiltFound>> tried(const std::vector<PourTilt>& tilts,
                                            const std::function<Result<double>(const PourTilt&)>& air) {
    std::vector<std::optional<TiltFound>> found(tilts.size());
    parallelFor(tilts.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (const Result<double> stays = air(tilts[i]))
                found[i] = {tilts[i], *stays};
    });
    return found;
}

/// The least air; of those that leave as little the least tilt, of these the first.
std::optional<TiltFound> bestOf(const std::vector<std::optional<TiltFound>>& found, double negligible) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::optional<TiltFound>& one : found)
        if (one)
            least = std::min(least, one->air);
    std::optional<TiltFound> best;
    for (const std::optional<TiltFound>& one : found)
        if (one && one->air <= least + negligible && (!best || one->tilt.degrees < best->tilt.degrees))
            best = one;
    return best;
}

} // namespace

Vector3d upWhenLeaning(Resting resting, double degrees, double towards) {
    const bool standing = resting == Resting::Standing;
    const Vector3d upright = standing ? Vector3d::UnitY() : Vector3d::UnitZ();
    if (degrees == 0)
        return upright;
    const Vector3d across = standing ? Vector3d::UnitZ() : Vector3d::UnitY();
    const Vector3d way = std::cos(radians(towards)) * Vector3d::UnitX() + std::sin(radians(towards)) * across;
    // What leans towards a way has up lean from it.
    return (std::cos(radians(degrees)) * upright - std::sin(radians(degrees)) * way).normalized();
}

std::string leaningWords(Resting resting, double towards) {
    constexpr std::array standing = {"the right", "half 1 and the right", "half 1", "half 1 and the left",
                                     "the left",  "half 2 and the left",  "half 2", "half 2 and the right"};
    constexpr std::array lying = {
        "the right", "the back and the right", "the back",  "the back and the left",
        "the left",  "the front and the left", "the front", "the front and the right"};
    const double turn = towards / eighth;
    const auto nearest = static_cast<std::size_t>(std::lround(turn - ways * std::floor(turn / ways))) % ways;
    return resting == Resting::Standing ? standing[nearest] : lying[nearest];
}

std::optional<TiltFound> leastAirTilt(const std::function<Result<double>(const PourTilt&)>& air,
                                      double negligible) {
    constexpr int step = 5; // degrees
    std::vector<PourTilt> coarse{{}};
    for (int degrees = step; degrees <= static_cast<int>(mostPourTilt); degrees += step)
        for (int way = 0; way < ways; ++way)
            coarse.push_back({false, static_cast<double>(degrees), way * eighth});
    std::vector<std::optional<TiltFound>> found = tried(coarse, air);
    const std::optional<TiltFound> best = bestOf(found, negligible);
    if (!best || best->tilt.degrees == 0)
        return best;
    std::vector<PourTilt> fine;
    for (int by = 1 - step; by < step; ++by)
        if (const double degrees = best->tilt.degrees + by; by != 0 && degrees <= mostPourTilt)
            fine.push_back({false, degrees, best->tilt.towards});
    for (std::optional<TiltFound>& one : tried(fine, air))
        found.push_back(std::move(one));
    return bestOf(found, negligible);
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/necks.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>

namespace moldwright {

namespace {

constexpr int kWays = 4;        ///< about the direction, in which an extent is measured
constexpr int kPlaces = 13;     ///< along the longest of them, at which a cut is weighed
constexpr double kMargin = 0.2; ///< of the extent, at either end, that a cut keeps clear of
constexpr int kAttempts = 6;    ///< the next best cuts, where one is not clean

/// A region's boundary, its faces running outward.
using Shell = std::vector<std::array<Eigen::Vector3d, 3>>;

Shell shellOf(const ChoiceMesh& choices, int region) {
    Shell shell;
    for (const ChoiceFace& face : choices.faces) {
        const int how = bounds(face, region);
        if (how == 0)
            continue;
        const auto corner = [&](std::size_t k) {
            return choices.points[static_cast<std::size_t>(face.corners[k])];
        };
        shell.push_back({corner(0), corner(how > 0 ? 1 : 2), corner(how > 0 ? 2 : 1)});
    }
    return shell;
}

struct Extent {
    Eigen::Vector3d way;
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    [[nodiscard]] double length() const { return high - low; }
};

Extent longestExtent(const Shell& shell, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d e1 = direction.unitOrthogonal();
    const Eigen::Vector3d e2 = direction.cross(e1);
    Extent longest;
    for (int i = 0; i < kWays; ++i) {
        const double angle = std::numbers::pi * i / kWays;
        Extent extent;
        extent.way = std::cos(angle) * e1 + std::sin(angle) * e2;
        for (const auto& face : shell)
            for (const Eigen::Vector3d& x : face) {
                extent.low = std::min(extent.low, extent.way.dot(x));
                extent.high = std::max(extent.high, extent.way.dot(x));
            }
        if (i == 0 || extent.length() > longest.length())
            longest = extent;
    }
    return longest;
}

/// Area of the shell's section at way·x = t: twice the sum over its edges seen from a point of the plane.
double sectionArea(const Shell& shell, const Eigen::Vector3d& way, double t) {
    double area = 0;
    for (const auto& face : shell) {
        std::array<double, 3> s{};
        for (std::size_t k = 0; k < 3; ++k)
            s[k] = way.dot(face[k]) - t;
        std::array<Eigen::Vector3d, 2> ends;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            if ((s[k] < 0) == (s[next] < 0))
                continue;
            // Into the half space beyond, or out of it.
            ends[s[k] < 0 ? 0 : 1] = face[k] + s[k] / (s[k] - s[next]) * (face[next] - face[k]);
        }
        if (std::min({s[0], s[1], s[2]}) < 0 && std::max({s[0], s[1], s[2]}) >= 0)
            area += way.dot(ends[0].cross(ends[1])) / 2;
    }
    return std::abs(area);
}

/// Where along an extent points stand, in order.
std::vector<double> heightsAlong(const Shell& shell, const Extent& extent) {
    std::vector<double> heights;
    for (const auto& face : shell)
        for (const Eigen::Vector3d& x : face)
            heights.push_back(extent.way.dot(x));
    std::sort(heights.begin(), heights.end());
    return heights;
}

/// The middle of the widest gap between points about t: no edge is cut close to its end.
double gapAbout(const std::vector<double>& heights, double t, double reach) {
    auto at = std::lower_bound(heights.begin(), heights.end(), t - reach);
    double widest = -1;
    double middle = t;
    for (double last = t - reach; last < t + reach; ++at) {
        const double next = at == heights.end() ? t + reach : std::min(*at, t + reach);
        if (next - last > widest) {
            widest = next - last;
            middle = (last + next) / 2;
        }
        if (at == heights.end())
            break;
        last = next;
    }
    return middle;
}

/// Places for a cut, the best first: little is cut and both parts are long.
std::vector<double> placesToCut(const Shell& shell, const Extent& extent) {
    const std::vector<double> heights = heightsAlong(shell, extent);
    const double step = (1 - 2 * kMargin) / (kPlaces - 1);
    std::vector<std::pair<double, double>> weighed;
    for (int i = 0; i < kPlaces; ++i) {
        const double share = kMargin + step * i;
        const double t = gapAbout(heights, extent.low + share * extent.length(), step * extent.length() / 2);
        weighed.emplace_back(sectionArea(shell, extent.way, t) / (share * (1 - share)), t);
    }
    std::stable_sort(weighed.begin(), weighed.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<double> places;
    places.reserve(kAttempts);
    for (int i = 0; i < kAttempts; ++i)
        places.push_back(weighed[static_cast<std::size_t>(i)].second);
    return places;
}

bool isUp(const Shell& shell) {
    double sum = 0;
    for (const auto& face : shell)
        for (const Eigen::Vector3d& x : face)
            sum += x.z();
    return sum > 0;
}

} // namespace

void divideAtNecks(ChoiceMesh& choices, int region, const Directions& directions, double longest,
                   const Task& task, const CutCheck& check) {
    std::vector<int> open{region};
    const auto separate = [&](int piece) {
        const std::vector<int> shells = separateShells(choices, piece);
        open.insert(open.end(), shells.begin(), shells.end());
    };
    if (divideRegion(choices, region, {})) {
        open.clear();
        const int above = choices.regions - 1;
        separate(region);
        separate(above);
    }
    while (!open.empty() && !task.stopped()) {
        const int piece = open.back();
        open.pop_back();
        const Shell shell = shellOf(choices, piece);
        const std::uint8_t side = isUp(shell) ? 1 : 2;
        const Extent extent = longestExtent(shell, directions.of(side));
        if (extent.length() <= longest)
            continue;
        for (const double place : placesToCut(shell, extent))
            if (divideRegion(choices, piece, {extent.way, place, side}, check)) {
                const int beyond = choices.regions - 1;
                separate(piece);
                separate(beyond);
                break;
            }
    }
}

} // namespace moldwright

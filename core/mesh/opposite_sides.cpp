// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/opposite_sides.h"

#include <algorithm>
#include <array>

namespace moldwright {

namespace {

struct Side {
    int high;
    int number;
    bool upward; ///< from the lower point to the higher
};

} // namespace

OppositeSides oppositeSides(const Triangles& F, int points) {
    const auto sides = static_cast<std::size_t>(F.size());
    OppositeSides opposite{std::vector<int>(sides, -1), false};
    // Sides sorted by their lower point: few share one.
    std::vector<std::size_t> first(static_cast<std::size_t>(points) + 1, 0);
    const auto ends = [&](std::size_t s) {
        const auto f = static_cast<Eigen::Index>(s / 3);
        const auto k = static_cast<Eigen::Index>(s % 3);
        return std::array{F(f, k), F(f, (k + 1) % 3)};
    };
    for (std::size_t s = 0; s < sides; ++s)
        ++first[static_cast<std::size_t>(std::ranges::min(ends(s))) + 1];
    for (std::size_t v = 0; v + 1 < first.size(); ++v)
        first[v + 1] += first[v];
    std::vector<Side> sorted(sides);
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (std::size_t s = 0; s < sides; ++s) {
        const auto [a, b] = ends(s);
        sorted[next[static_cast<std::size_t>(std::min(a, b))]++] = {std::max(a, b), static_cast<int>(s),
                                                                    a < b};
    }
    for (std::size_t v = 0; v + 1 < first.size(); ++v)
        for (std::size_t i = first[v]; i < first[v + 1]; ++i)
            for (std::size_t j = i + 1; j < first[v + 1]; ++j) {
                if (sorted[i].high != sorted[j].high)
                    continue;
                int& at = opposite.of[static_cast<std::size_t>(sorted[i].number)];
                int& back = opposite.of[static_cast<std::size_t>(sorted[j].number)];
                if (sorted[i].upward == sorted[j].upward || at >= 0 || back >= 0) {
                    opposite.crowded = true;
                    continue;
                }
                at = sorted[j].number;
                back = sorted[i].number;
            }
    return opposite;
}

bool closedManifold(const Triangles& F, int points) {
    const OppositeSides opposite = oppositeSides(F, points);
    if (opposite.crowded || std::ranges::any_of(opposite.of, [](int side) { return side < 0; }))
        return false;
    std::vector<char> turned(opposite.of.size(), 0);
    std::vector<char> hasFan(static_cast<std::size_t>(points), 0);
    for (int start = 0; start < F.size(); ++start) {
        if (turned[static_cast<std::size_t>(start)])
            continue;
        char& fan = hasFan[static_cast<std::size_t>(F(start / 3, start % 3))];
        if (fan)
            return false;
        fan = 1;
        // Each side begins at the point; the next one is the opposite of the side that ends there.
        for (int s = start, ending = 0; !turned[static_cast<std::size_t>(s)];
             ending = s - s % 3 + (s + 2) % 3, s = opposite.of[static_cast<std::size_t>(ending)])
            turned[static_cast<std::size_t>(s)] = 1;
    }
    return true;
}

} // namespace moldwright

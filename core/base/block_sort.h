// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/parallel.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace moldwright {

/// Sorts values of which no two are equal, as std::sort does: in blocks side by side, which are then merged
/// two by two, so that a task that is stopped ends it soon.
template <class T>
void sortInBlocks(std::vector<T>& values) {
    constexpr std::size_t block = 1 << 15;
    const auto at = [&](std::size_t i) {
        return values.begin() + static_cast<std::ptrdiff_t>(std::min(i, values.size()));
    };
    parallelFor(values.size(), block,
                [&](std::size_t begin, std::size_t end) { std::sort(at(begin), at(end)); });
    for (std::size_t width = block; width < values.size(); width *= 2)
        parallelFor(values.size(), 2 * width, [&](std::size_t begin, std::size_t end) {
            std::inplace_merge(at(begin), at(begin + width), at(end));
        });
}

} // namespace moldwright

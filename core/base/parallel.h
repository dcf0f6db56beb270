// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace moldwright {

/// Limits how many threads parallel loops use; 0 means all cores. Results never depend on it.
void setThreadCount(int threads);
[[nodiscard]] int threadCount();

/// Runs body(begin, end) over [0, count) in blocks of `grain`. The blocks are the same for any number of
/// threads, and each runs once, in no particular order; body must write only to what its block owns.
void parallelFor(std::size_t count, std::size_t grain,
                 const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Runs tasks that have nothing to do with each other, side by side where cores are free.
void parallelInvoke(const std::vector<std::function<void()>>& tasks);

/// Sum of partial(begin, end) over the blocks of [0, count), added in block order: the same bits for any
/// number of threads. T needs a zero value and +=.
template <class T>
[[nodiscard]] T parallelSum(std::size_t count, std::size_t grain, const T& zero,
                            const std::function<T(std::size_t begin, std::size_t end)>& partial) {
    const std::size_t blocks = (count + grain - 1) / grain;
    std::vector<T> parts(blocks, zero);
    parallelFor(count, grain,
                [&](std::size_t begin, std::size_t end) { parts[begin / grain] = partial(begin, end); });
    T sum = zero;
    for (const T& part : parts)
        sum += part;
    return sum;
}

} // namespace moldwright

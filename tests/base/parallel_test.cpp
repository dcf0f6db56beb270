// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/parallel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace moldwright;

TEST(Parallel, EveryIndexRunsOnce) {
    std::vector<int> runs(10'001, 0);
    parallelFor(runs.size(), 97, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            ++runs[i];
    });
    for (const int n : runs)
        ASSERT_EQ(n, 1);
}

TEST(Parallel, SumHasTheSameBitsForAnyNumberOfThreads) {
    const auto sum = [] {
        return parallelSum<double>(100'000, 1000, 0.0, [](std::size_t begin, std::size_t end) {
            double part = 0;
            for (std::size_t i = begin; i < end; ++i)
                part += std::sin(static_cast<double>(i)) * 1e-3;
            return part;
        });
    };
    setThreadCount(1);
    const double one = sum();
    for (const int threads : {2, 3, 8}) {
        setThreadCount(threads);
        EXPECT_EQ(sum(), one) << threads << " threads";
    }
    setThreadCount(0);
}

TEST(Parallel, EachTaskRunsOnceAndBeforeTheEnd) {
    for (const int threads : {1, 2, 8}) {
        setThreadCount(threads);
        std::vector<int> runs(5, 0);
        std::vector<std::function<void()>> tasks;
        for (int& n : runs)
            tasks.emplace_back([&n] { ++n; });
        parallelInvoke(tasks);
        EXPECT_EQ(runs, std::vector<int>(5, 1)) << threads << " threads";
    }
    setThreadCount(0);
    parallelInvoke({});
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/stop_point.h"

#include "base/block_sort.h"
#include "base/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <random>
#include <vector>

using namespace moldwright;

TEST(StopPoint, WorkThatNobodyStopsReturnsWhatItFound) {
    EXPECT_EQ(unlessStopped(Task(), [] { return 7; }), 7);
    EXPECT_EQ(StopScope::current(), nullptr);
    stopPoint(); // belongs to no task
}

TEST(StopPoint, EndsALoopThatTakesNoTask) {
    const Task task;
    int steps = 0;
    const auto found = unlessStopped(task, [&] {
        for (int i = 0; i < 10000; ++i) {
            stopPointAt(i);
            if (++steps == 100)
                task.cancel();
        }
        return steps;
    });
    EXPECT_FALSE(found);
    EXPECT_EQ(steps, 1024);
    EXPECT_EQ(StopScope::current(), nullptr) << "the thread's next work is not stopped";
}

TEST(StopPoint, EndsParallelLoopsWithinEachOther) {
    for (const int threads : {1, 2, 4}) {
        setThreadCount(threads);
        const Task task;
        std::atomic<int> blocks = 0;
        const auto found = unlessStopped(task, [&] {
            parallelFor(100, 1, [&](std::size_t, std::size_t) {
                parallelFor(100, 1, [&](std::size_t, std::size_t) {
                    if (++blocks == 50)
                        task.cancel();
                });
            });
            return true;
        });
        EXPECT_FALSE(found);
        EXPECT_LT(blocks, 1000);
    }
    setThreadCount(0);
}

TEST(StopPoint, IsNoFailureForThoseOnTheWay) {
    const Task task;
    task.cancel();
    const auto found = unlessStopped(task, [] {
        try {
            stopPoint();
        } catch (const std::exception&) {
            return false;
        }
        return true;
    });
    EXPECT_FALSE(found);
}

TEST(BlockSort, SortsAsOneSortDoes) {
    std::mt19937 random(3);
    for (const std::size_t count : {0UL, 1UL, 1000UL, 32768UL, 32769UL, 200001UL}) {
        std::vector<std::pair<unsigned, std::size_t>> values;
        for (std::size_t i = 0; i < count; ++i)
            values.emplace_back(static_cast<unsigned>(random() % 1000), i);
        auto sorted = values;
        std::sort(sorted.begin(), sorted.end());
        sortInBlocks(values);
        EXPECT_EQ(values, sorted);
    }
}

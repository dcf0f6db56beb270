// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/task.h"

#include <gtest/gtest.h>

#include <vector>

using namespace moldwright;

TEST(Task, PartsReportWithinTheirRange) {
    std::vector<double> seen;
    const Task whole([&](double fraction, const std::string&) { seen.push_back(fraction); });
    const Task half = whole.part(0.5, 1);
    half.progress(0, "a");
    half.part(0, 0.5).progress(1, "b");
    half.progress(7, "c");
    EXPECT_EQ(seen, (std::vector<double>{0.5, 0.75, 1.0}));
}

TEST(Task, CancelReachesEveryPart) {
    const Task whole;
    const Task part = whole.part(0, 0.1);
    EXPECT_FALSE(part.stopped());
    whole.cancel();
    EXPECT_TRUE(part.stopped());
}

TEST(Task, ALegIsCancelledAloneAndWithTheWhole) {
    std::vector<double> seen;
    const Task whole;
    const Task first =
        whole.part(0, 0.5).leg([&](double fraction, const std::string&) { seen.push_back(fraction); });
    first.part(0, 0.5).progress(1, "a");
    EXPECT_EQ(seen, std::vector<double>{0.5});
    first.cancel();
    EXPECT_TRUE(first.part(0, 1).stopped());
    EXPECT_FALSE(whole.stopped());
    const Task second = whole.leg({});
    EXPECT_FALSE(second.stopped());
    whole.cancel();
    EXPECT_TRUE(second.stopped());
}

TEST(Task, DeadlineStops) {
    const Task task;
    task.setDeadline(std::chrono::steady_clock::now() + std::chrono::hours(1));
    EXPECT_FALSE(task.stopped());
    task.setDeadline(std::chrono::steady_clock::now());
    EXPECT_TRUE(task.stopped());
}

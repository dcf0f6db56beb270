// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/pipeline.h"

#include "project/edits.h"
#include "project/some_project.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::test;

TEST(Pipeline, OfAnEmptyProjectIsEmpty) {
    const Evaluation evaluation = evaluate({}).value();
    EXPECT_FALSE(evaluation.part || evaluation.cast || evaluation.mold || evaluation.moldFailure);
}

TEST(Pipeline, BuildsTheMoldOfTheCast) {
    const Evaluation evaluation = evaluate(someProject()).value();
    ASSERT_NE(evaluation.mold, nullptr);
    EXPECT_TRUE(evaluation.mold->verified());
    EXPECT_EQ(evaluation.mold->settings, someProject().mold);
    ASSERT_TRUE(evaluation.cast.has_value());
    EXPECT_TRUE(evaluation.cast->castable());
    EXPECT_TRUE(evaluation.part.has_value());
}

TEST(Pipeline, WithoutACastThereIsNoMold) {
    const Evaluation evaluation = evaluate(withPins(someProject(), {})).value();
    EXPECT_TRUE(evaluation.part.has_value());
    EXPECT_FALSE(evaluation.cast.has_value());
    EXPECT_EQ(evaluation.mold, nullptr);
}

TEST(Pipeline, CanBeCancelled) {
    const Task task;
    task.cancel();
    const Result<Evaluation> result = evaluate(someProject(), task);
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/stencil_letters.h"
#include "support/plan_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace moldwright;
using Eigen::Vector2d;

namespace {

const std::string everyLetter = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-.,:/%°#+()ÄÖÜÀÉÎÑÇÅ";

/// Whether two edges of the outline that are no neighbours meet.
bool crossesItself(const PlanShape& shape) {
    const std::size_t n = shape.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j) {
            if (i == 0 && j == n - 1)
                continue;
            // A shape of two points is their segment.
            if (planDistance({shape[i], shape[i + 1]}, {shape[j], shape[(j + 1) % n]}) <= 0)
                return true;
        }
    return false;
}

} // namespace

TEST(StencilLetters, AStrokeIsAsWideAsItShallBe) {
    const PlanShape straight = strokeOutline({{0, 0}, {10, 0}}, 2);
    EXPECT_EQ(straight.size(), 4U);
    EXPECT_NEAR(test::planArea(straight), 20, 1e-12);
    // A mitred right angle: both arms, and their common corner once.
    EXPECT_NEAR(test::planArea(strokeOutline({{0, 0}, {10, 0}, {10, 5}}, 2)), 2 * 10 + 2 * 5, 1e-12);
    EXPECT_NEAR(test::planArea(strokeOutline({{0, 0}, {10, 0}, {10, -5}}, 2)), 2 * 10 + 2 * 5, 1e-12);
    // A sharp one is cut off where it would stick out by more than the stroke's width.
    for (const Vector2d& p : strokeOutline({{0, 0}, {10, 0}, {0, 2}}, 2))
        EXPECT_LT(p.x(), 11.1);
}

TEST(StencilLetters, KeepTheirStrokesApart) {
    constexpr double height = 7; // a stroke is 1 mm wide
    const Result<StencilText> text = stencilText({everyLetter}, height);
    ASSERT_TRUE(text) << text.error().english();
    for (std::size_t i = 0; i < text->strokes.size(); ++i) {
        const PlanShape& stroke = text->strokes[i];
        EXPECT_GT(test::planArea(stroke), 0.5) << "counter-clockwise";
        EXPECT_FALSE(crossesItself(stroke)) << i;
        for (std::size_t j = i + 1; j < text->strokes.size(); ++j)
            EXPECT_GE(planDistance(stroke, text->strokes[j]), 0.6 - 1e-9)
                << i << " and " << j << " at " << stroke.front().transpose();
    }
}

TEST(StencilLetters, AreAsHighAsAskedForAndInTheirPlace) {
    const Result<StencilText> one = stencilText({"I"}, 7);
    ASSERT_TRUE(one);
    EXPECT_NEAR(one->box.sizes().y(), 6, 1e-9) << "square ends on the line";
    EXPECT_NEAR(one->box.sizes().x(), 1, 1e-9);
    const Result<StencilText> h = stencilText({"E"}, 7);
    EXPECT_NEAR(h->box.sizes().y(), 7, 1e-9);
    const Result<StencilText> both = stencilText({"E", "EE"}, 7);
    EXPECT_NEAR(both->box.sizes().y(), 7 + 11, 1e-9);
    EXPECT_NEAR(both->box.center().x(), 0.25 - 0.25, 0.26) << "lines are centred";
    EXPECT_EQ(both->strokes.size(), 3 * h->strokes.size());
}

TEST(StencilLetters, SmallOnesBecomeCapitalsAndMarksArePutOn) {
    EXPECT_EQ(stencilText({"rabbit"}, 5)->strokes, stencilText({"RABBIT"}, 5)->strokes);
    EXPECT_EQ(stencilText({"möbel"}, 5)->strokes, stencilText({"MÖBEL"}, 5)->strokes);
    EXPECT_EQ(stencilText({"Ö"}, 5)->strokes.size(), stencilText({"O"}, 5)->strokes.size() + 2);
    EXPECT_EQ(stencilText({"É"}, 5)->strokes.size(), stencilText({"E"}, 5)->strokes.size() + 1);
}

TEST(StencilLetters, ThatThereAreNotAreNamed) {
    for (const std::string unknown : {"?", "ß", "模", "😀", "_"}) {
        const Result<StencilText> text = stencilText({"A" + unknown + "B"}, 5);
        ASSERT_FALSE(text) << unknown;
        EXPECT_EQ(text.error().code, ErrorCode::Usage);
        EXPECT_NE(text.error().english().find("\"" + unknown + "\""), std::string::npos)
            << text.error().english();
    }
}

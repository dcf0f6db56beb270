// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/mold_settings_json.h"

#include "support/materials.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace moldwright;

TEST(MoldSettingsJson, KeepsEveryValue) {
    MoldSettings settings;
    settings.wall = 7.5;
    settings.blockDensity = 1.24;
    settings.layout = {3, 5, Arrangement::Free, Alternation::Flip, 4.25, {{1, -2.5, 90}, {40, 0, 0}}};
    settings.shrink = {{1, 2, 3}, ShrinkFormula::Divide, {4, 5, 6}};
    settings.spout = {true, 8, 14, 5, 6, PourDirection::Turn270, {}, 0, {true, 12, 135}};
    settings.vents = {true, 2, 3};
    settings.keys = {4, 5, 3, 0.3, 7, 2};
    settings.slits = {2, 5, 10, 1};
    settings.bolts = {4, 5, 2, 2.5};
    settings.ejectors = {3, 2.5, 1};
    settings.overflows = {2, 8, 2, 3};
    settings.spout.resting = Resting::Lying;
    settings.spout.neck = 2.5;
    settings.spout.runners = Runners::Balanced;
    settings.hollow.wall = 3;
    settings.shape = BlockShape::Shell;
    settings.outerDraft = -4;
    settings.vents.depth = 0.03;
    settings.machines = {{220, 210, 250}, 50};
    settings.pockets = {3, PocketShape::Rectangle, 8, 12.5, 4, 0.05, 0};
    settings.plaque = {"Box|half {half}", 4.5, 0.4};
    settings.stock = {80, 125.5};
    settings.material = test::materialCalled("soap");
    settings.material->process = "pour";
    settings.material->ventDepth = MaterialValue{0.02, "0.01 to 0.03", "us", "make a coupon"};
    settings.material->preparation = {"seal", "grease", "fill", "wait", "us"};
    settings.placed = {{Placeable::Spout, 0, {3.5, 40}}, {Placeable::Key, 2, {-20.25, 1e-3}}};
    EXPECT_EQ(moldSettingsFrom(moldSettingsJson(settings)), settings);
}

TEST(MoldSettingsJson, TakesDefaultsForWhatFilesOfOldDoNotName) {
    const auto old = nlohmann::ordered_json::parse(
        R"({"wall": 6, "floor": 5, "ceiling": 5, "step": 1, "pressure_bar": 4})");
    MoldSettings expected;
    expected.wall = 6;
    EXPECT_EQ(moldSettingsFrom(old), expected);
}

TEST(MoldSettingsJson, UnknownNamesAreAnError) {
    EXPECT_ANY_THROW(static_cast<void>(
        moldSettingsFrom(nlohmann::ordered_json::parse(R"({"layout": {"arrangement": "heap"}})"))));
    EXPECT_ANY_THROW(static_cast<void>(
        moldSettingsFrom(nlohmann::ordered_json::parse(R"({"layout": {"places": [{"at": [1]}]}})"))));
}

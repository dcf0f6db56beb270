// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/material_choice.h"

#include "support/materials.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace moldwright;

namespace {

Material nylon() {
    Material m = test::materialCalled("Nylon");
    m.shrinkPercent = {1.2, "", "chart"};
    m.divide = true;
    m.draftDegrees = {2, "", "guide"};
    m.density = {1.14, "", "sheet", "ask the data sheet"};
    m.ventDepth = MaterialValue{0.01, "", "chart"};
    m.preparation = {{}, "Silicone spray", {}, "20 s at 80 °C", "us"};
    return m;
}

bool isTold(const std::vector<Message>& notes, const std::string& words) {
    return std::ranges::any_of(
        notes, [&](const Message& note) { return note.english().find(words) != std::string::npos; });
}

} // namespace

TEST(MaterialChoice, TakesWhatTheMaterialSays) {
    MoldSettings before;
    before.wall = 9;
    const MoldSettings taken = withMaterial(before, nylon());
    EXPECT_EQ(taken.shrink.percent, Eigen::Vector3d::Constant(1.2));
    EXPECT_EQ(taken.shrink.formula, ShrinkFormula::Divide);
    EXPECT_EQ(taken.density, 1.14);
    EXPECT_EQ(taken.vents.depth, 0.01);
    EXPECT_EQ(taken.wall, 9);
    EXPECT_EQ(taken.material, nylon());
    const MoldSettings without = withoutMaterial(taken);
    EXPECT_FALSE(without.material);
    EXPECT_EQ(without.density, 1.14) << "values stay";
}

TEST(MaterialChoice, DepthOfVentsGoesWithTheMaterialThatAskedForIt) {
    Material wax = nylon();
    wax.ventDepth.reset();
    MoldSettings settings = withMaterial({}, nylon());
    EXPECT_EQ(withMaterial(settings, wax).vents.depth, 0);
    settings.vents.depth = 0.5; // by hand
    EXPECT_EQ(withMaterial(settings, wax).vents.depth, 0.5);
}

TEST(MaterialChoice, NotesTellWhereValuesComeFromAndWhatToDo) {
    EXPECT_TRUE(materialNotes({}, 1).empty());
    MoldSettings settings = withMaterial({}, nylon());
    settings.vents.on = true;
    const std::vector<Message> notes = materialNotes(settings, 1);
    EXPECT_TRUE(isTold(notes, "Nylon: Shrink 1.2 % (chart)."));
    EXPECT_TRUE(isTold(notes, "Density 1.14 g/cm³ (sheet; ask the data sheet)."));
    EXPECT_TRUE(isTold(notes, "Depth of vents in the parting plane 0.01 mm"));
    EXPECT_TRUE(isTold(notes, "designed with 1° of draft; Nylon usually asks for 2° (guide)"));
    EXPECT_TRUE(isTold(notes, "Release agent: Silicone spray"));
    EXPECT_TRUE(isTold(notes, "Setting: 20 s at 80 °C"));
    EXPECT_FALSE(isTold(materialNotes(settings, 2), "usually asks"));
}

TEST(MaterialChoice, WhatWasSetOtherwiseIsSaid) {
    MoldSettings settings = withMaterial({}, nylon());
    settings.shrink.percent.z() = 1.5;
    EXPECT_TRUE(isTold(materialNotes(settings, 2), "Shrink is set otherwise here; usual is 1.2 % (chart)"));
    const std::vector<MaterialSetting> all = materialSettings(settings);
    ASSERT_EQ(all.size(), 2U) << "no vents, no depth";
    EXPECT_FALSE(all[0].isTaken);
    EXPECT_TRUE(all[1].isTaken);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/presets.h"

#include "support/folders.h"
#include "support/materials.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace moldwright;
using test::ScratchFolder;

namespace {

MoldSettings shopSettings() {
    MoldSettings settings;
    settings.wall = 8;
    settings.keys.count = 4;
    settings.stock = {80, 120};
    settings.machines = {{250, 210, 200}, 60};
    settings.shrink.percent.setConstant(1.6);
    settings.density = 0.9;
    settings.material = test::materialCalled("pp");
    return settings;
}

} // namespace

TEST(Presets, BringEverythingButThePartsMaterial) {
    const ScratchFolder scratch;
    const auto folder = scratch.path() / "not/yet/there";
    EXPECT_TRUE(presetNames(folder).empty());
    ASSERT_TRUE(savePreset(folder, "Our press", shopSettings()));
    EXPECT_EQ(presetNames(folder), std::vector<std::string>{"Our press"});
    MoldSettings here;
    here.shrink.percent.setConstant(0.4);
    here.density = 1.1;
    here.material = test::materialCalled("soap");
    EXPECT_FALSE(presetHolds(here, folder, "Our press"));
    const Result<MoldSettings> taken = withPreset(here, folder, "Our press");
    ASSERT_TRUE(taken);
    MoldSettings expected = shopSettings();
    expected.shrink = here.shrink;
    expected.density = here.density;
    expected.material = here.material;
    EXPECT_EQ(*taken, expected);
    EXPECT_TRUE(presetHolds(*taken, folder, "Our press"));
}

TEST(Presets, OfOneNameAreReplacedAndRemoved) {
    const ScratchFolder scratch;
    MoldSettings settings = shopSettings();
    ASSERT_TRUE(savePreset(scratch.path(), "A", settings));
    settings.wall = 12;
    ASSERT_TRUE(savePreset(scratch.path(), "A", settings));
    EXPECT_EQ(withPreset({}, scratch.path(), "A")->wall, 12);
    ASSERT_TRUE(removePreset(scratch.path(), "A"));
    EXPECT_TRUE(presetNames(scratch.path()).empty());
    EXPECT_EQ(removePreset(scratch.path(), "A").error().code, ErrorCode::Usage);
}

TEST(Presets, OfNoNameSayWhichThereAre) {
    const ScratchFolder scratch;
    ASSERT_TRUE(savePreset(scratch.path(), "Large", shopSettings()));
    const Result<MoldSettings> none = withPreset({}, scratch.path(), "Small");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::Usage);
    EXPECT_NE(none.error().english().find("Large"), std::string::npos);
}

TEST(Presets, StayInTheirFolder) {
    const ScratchFolder scratch;
    for (const char* name : {"", "../up", "a/b", ".hidden", "tail ", "line\n"}) {
        const Result<void> saved = savePreset(scratch.path() / "in", name, shopSettings());
        ASSERT_FALSE(saved) << name;
        EXPECT_EQ(saved.error().code, ErrorCode::Usage);
    }
    std::ofstream(scratch.path() / "up.json") << "{}";
    EXPECT_FALSE(removePreset(scratch.path() / "in", "../up"));
    EXPECT_TRUE(std::filesystem::exists(scratch.path() / "up.json"));
}

TEST(Presets, ThatCannotBeUnderstoodAreNamed) {
    const ScratchFolder scratch;
    for (const char* text : {"", "{}", R"({"mold": {"wall": "thick"}})", R"({"mold": {"shape": "cloud"}})"}) {
        std::ofstream(scratch.path() / "odd.json") << text;
        const Result<MoldSettings> read = withPreset({}, scratch.path(), "odd");
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().code, ErrorCode::BadInput);
        EXPECT_FALSE(presetHolds({}, scratch.path(), "odd"));
    }
}

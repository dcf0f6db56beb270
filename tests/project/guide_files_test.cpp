// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/guide_files.h"

#include "support/folders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace moldwright;
using Eigen::Vector3d;

namespace {

IndexedMesh cube() {
    return test::box(Vector3d::Zero(), Vector3d::Constant(10));
}

Result<std::vector<Pin>> readText(const std::string& text) {
    const test::ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "pins.json";
    std::ofstream(file) << text;
    return readPins(file, cube());
}

} // namespace

TEST(GuideFiles, PinsComeBackToTheBit) {
    const std::vector<Pin> pins = {{Vector3d(1.0 / 3, 2, 9.87654321)}, {Vector3d(10, 5, 5)}};
    const Result<std::vector<Pin>> read = readText(pinsText(pins));
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, pins);
    EXPECT_TRUE(readText(pinsText({}))->empty());
}

TEST(GuideFiles, APinOutsideThePartIsRefusedWithItsDistance) {
    const Result<std::vector<Pin>> read = readText(pinsText({{Vector3d(5, 5, 5)}, {Vector3d(5, 5, 12)}}));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::BadInput);
    EXPECT_EQ(read.error().message.arguments[1], "2") << "it is the second";
    EXPECT_EQ(read.error().message.arguments[2], "2") << "and 2 mm outside";
}

TEST(GuideFiles, WhatIsNoListOfPinsIsRefused) {
    for (const char* text : {"", "[1, 2]", "{\"pins\": 3}", "{\"pins\": [{\"point\": [1, 2]}]}"})
        EXPECT_FALSE(readText(text)) << text;
}

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

Result<std::vector<NamedPin>> readText(const std::string& text) {
    const test::ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "pins.json";
    std::ofstream(file) << text;
    return readPins(file, cube());
}

Result<std::vector<ImportantRegion>> readWeightsText(const std::string& text) {
    const test::ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "weights.json";
    std::ofstream(file) << text;
    return readWeights(file, cube());
}

} // namespace

TEST(GuideFiles, PinsComeBackToTheBit) {
    const std::vector<NamedPin> pins = {{{Vector3d(1.0 / 3, 2, 9.87654321)}, {}},
                                        {{Vector3d(10, 5, 5)}, "left \"ear\" ∅"}};
    const Result<std::vector<NamedPin>> read = readText(pinsText(pins));
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, pins);
    EXPECT_TRUE(readText(pinsText({}))->empty());
}

TEST(GuideFiles, APinOutsideThePartIsRefusedWithItsDistance) {
    const Result<std::vector<NamedPin>> read =
        readText(pinsText({{{Vector3d(5, 5, 5)}, {}}, {{Vector3d(5, 5, 12)}, {}}}));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::BadInput);
    EXPECT_EQ(read.error().message.arguments[1], "2") << "it is the second";
    EXPECT_EQ(read.error().message.arguments[2], "2") << "and 2 mm outside";
}

TEST(GuideFiles, WhatIsNoListOfPinsIsRefused) {
    for (const char* text : {"", "[1, 2]", "{\"pins\": 3}", "{\"pins\": [{\"point\": [1, 2]}]}"})
        EXPECT_FALSE(readText(text)) << text;
}

TEST(GuideFiles, PlacesAreReadFromAListOfFeaturesSuchAsAMoldsOwn) {
    const auto read = [](const std::string& text) {
        const test::ScratchFolder folder;
        const std::filesystem::path file = folder.path() / "places.json";
        std::ofstream(file) << text;
        return readPlaces(file);
    };
    const Result<PlacedFeatures> placed = read(R"({"features": [
        {"kind": "block", "name": "Block", "place": [0, 0, 0]},
        {"kind": "key", "number": 2, "at": [-20.5, 3], "diameter": 6},
        {"kind": "overflow", "number": 3, "at": [7, -8]},
        {"kind": "ejector", "number": 1, "at": [1, 2]},
        {"kind": "ejector", "number": 1, "at": [1, 2]},
        {"kind": "spout", "number": 1, "at": [4.25, 60]}]})");
    ASSERT_TRUE(placed) << placed.error().english();
    const PlacedFeatures expected = {{Placeable::Spout, 0, {4.25, 60}},
                                     {Placeable::Key, 1, {-20.5, 3}},
                                     {Placeable::Ejector, 0, {1, 2}},
                                     {Placeable::Overflow, 2, {7, -8}}};
    EXPECT_EQ(*placed, expected);
    for (const char* entry :
         {R"({"kind": "key", "number": 0, "at": [1, 2]})", R"({"kind": "key", "at": [1, 2]})",
          R"({"kind": "lock", "number": 1, "at": [1, 2]})", R"({"kind": "key", "number": 1, "at": [1]})",
          R"({"kind": "key", "number": 1, "at": [1, 2]}, {"kind": "key", "number": 1, "at": [1, 3]})"})
        EXPECT_FALSE(read(std::string(R"({"features": [)") + entry + "]}")) << entry;
    EXPECT_FALSE(read(R"({"places": []})"));
}

TEST(GuideFiles, RegionsComeBackToTheBit) {
    const std::vector<ImportantRegion> regions = {{"left \"eye\"", {0, 3, 7}, {2, 16, 1.0 / 3 + 1}, 0.1},
                                                  {"Logo ∅", {1, 2}, {4, 4}, 0}};
    const Result<std::vector<ImportantRegion>> read = readWeightsText(weightsText(regions));
    ASSERT_TRUE(read) << read.error().english();
    EXPECT_EQ(*read, regions);
    EXPECT_TRUE(readWeightsText(weightsText({}))->empty());
}

TEST(GuideFiles, OfAFaceListedTwiceTheLargerWeightHolds) {
    const auto read = readWeightsText(R"({"regions": [{"faces": [5, 1, 5], "weight": [2, 3, 8]}]})");
    ASSERT_TRUE(read) << read.error().english();
    EXPECT_EQ(*read, (std::vector<ImportantRegion>{{"1", {1, 5}, {3, 8}, 0}}));
}

TEST(GuideFiles, WeightsThatDoNotFitTheirFacesAreRefused) {
    for (const char* weight : {"0.5", "70000", "[2]", "[2, 3, 4]", "[2, 0]", "[2, \"x\"]", "\"2\""}) {
        const auto read =
            readWeightsText(std::string(R"({"regions": [{"faces": [0, 1], "weight": )") + weight + "}]}");
        ASSERT_FALSE(read) << weight;
        EXPECT_NE(read.error().english().find("weight"), std::string::npos);
    }
}

// SPDX-License-Identifier: AGPL-3.0-or-later
// The command `pins`, and what `design` does with pins and weights, by running the real program.
#include "castability/mold_state.h"
#include "cli/run_program.h"
#include "exchange/mesh_file.h"
#include "mesh/measures.h"
#include "support/folders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <numbers>

using namespace moldwright;
using Json = nlohmann::ordered_json;

namespace {

Eigen::Vector3d vectorOf(const Json& json) {
    return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

class PinsCommands : public testing::Test {
protected:
    std::string in(const std::string& name) const { return m_folder.path() / name; }
    std::string write(const std::string& name, const IndexedMesh& mesh) const {
        EXPECT_TRUE(writeMesh(in(name), mesh, MeshFormat::Ply));
        return in(name);
    }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(in(name)) << text;
        return in(name);
    }
    Json jsonIn(const std::string& name) const {
        std::ifstream file(in(name));
        return Json::parse(file);
    }

    /// A bar along x, 80 mm long, bent like a bow: its ends hang `sag` below its middle.
    std::string bow(double sag) const {
        IndexedMesh mesh = test::sphere({0, 0, 0}, 1, 4);
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            const double x = mesh.V(v, 0);
            mesh.V.row(v) << 40 * x, 7 * mesh.V(v, 1), 6 * mesh.V(v, 2) - sag * x * x;
        }
        return write("bow.ply", mesh);
    }

    /// Designs the bow with pins at its ends and its middle and checks that they end in the plane.
    void expectPinsInPlane(const std::string& pins, const std::vector<std::string>& plane) {
        std::vector<std::string> arguments = {"design",  bow(12),  "--out",
                                              in("out"), "--pins", write("pins.json", pins)};
        arguments.insert(arguments.end(), plane.begin(), plane.end());
        const test::Run run = test::runProgram(arguments);
        ASSERT_EQ(run.exitCode, 0) << run.err << run.out;
        const Json design = jsonIn("out/design.json");
        const PartingPlane parting{vectorOf(design["plane"]), design["plane"][3].get<double>()};
        const double size = design["input"]["diagonal"].get<double>();
        const Json given = Json::parse(pins)["pins"];
        ASSERT_EQ(design["pins"].size(), given.size());
        for (std::size_t i = 0; i < given.size(); ++i) {
            EXPECT_EQ(design["pins"][i]["point"], given[i]["point"]);
            EXPECT_LE(design["pins"][i]["distance_from_plane"].get<double>(), 1e-6 * size);
            EXPECT_LE(std::abs(parting.distance(vectorOf(design["pins"][i]["place"]))), 1e-6 * size);
        }
    }

    test::ScratchFolder m_folder;
};

} // namespace

TEST_F(PinsCommands, PinsListsTheHighestRankFirst) {
    const test::Run run =
        test::runProgram({"pins", bow(12), "--plane", "0", "0", "1", "0", "--count", "9", "--json", "-"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Json found = Json::parse(run.out);
    ASSERT_EQ(found["pins"].size(), 9U);
    double before = 1;
    int tips = 0;
    double best = -1;
    for (const Json& pin : found["pins"]) {
        for (const char* key : {"point", "radius", "kind", "rank", "area_share", "gain"})
            EXPECT_TRUE(pin.contains(key)) << key;
        EXPECT_LE(pin["rank"].get<double>(), before);
        before = pin["rank"].get<double>();
        tips += pin["kind"] == "tip";
        best = std::max(best, pin["gain"].get<double>());
    }
    EXPECT_GE(tips, 2);
    EXPECT_GT(best, 0.01); // the ends hang below the plane
    EXPECT_NEAR(vectorOf(found["d1"]).norm(), 1, 1e-9);
}

TEST_F(PinsCommands, WithoutAPlaneThereIsNoGainAndSizesFollowTheOptions) {
    const test::Run plain = test::runProgram({"pins", bow(12), "--json", "-"});
    ASSERT_EQ(plain.exitCode, 0) << plain.err;
    const Json one = Json::parse(plain.out);
    EXPECT_FALSE(one.contains("plane"));
    EXPECT_FALSE(one["pins"][0].contains("gain"));
    const test::Run scaled = test::runProgram({"pins", bow(12), "--scale", "2", "--json", "-"});
    ASSERT_EQ(scaled.exitCode, 0) << scaled.err;
    const Json two = Json::parse(scaled.out);
    ASSERT_EQ(two["pins"].size(), one["pins"].size());
    for (std::size_t i = 0; i < one["pins"].size(); ++i)
        EXPECT_LT((vectorOf(two["pins"][i]["point"]) - 2 * vectorOf(one["pins"][i]["point"])).norm(), 1e-3);
    const test::Run best = test::runProgram({"pins", bow(12), "--plane", "auto", "--json", "-"});
    ASSERT_EQ(best.exitCode, 0) << best.err;
    EXPECT_TRUE(Json::parse(best.out).contains("plane"));
}

TEST_F(PinsCommands, PinsGivesTheSameBytesForAnyNumberOfThreads) {
    const std::string part = bow(12);
    const std::vector<std::string> arguments = {"pins", part, "--plane", "0", "0", "1", "0", "--json", "-"};
    std::vector<std::string> one = arguments;
    one.insert(one.end(), {"--threads", "1"});
    std::vector<std::string> three = arguments;
    three.insert(three.end(), {"--threads", "3"});
    EXPECT_EQ(test::runProgram(one).out, test::runProgram(three).out);
}

TEST_F(PinsCommands, PinnedPointsInsideEndInThePlane) {
    expectPinsInPlane(
        R"({"pins": [{"point": [-36, 0, -9.7]}, {"point": [0, 0, 0]}, {"point": [36, 0, -9.7]}]})",
        {"--plane", "0", "0", "1", "-1"});
}

TEST_F(PinsCommands, PinnedPointsOfTheSurfaceEndInThePlane) {
    expectPinsInPlane(R"({"pins": [{"point": [-30, 4.63, -6.75]}, {"point": [-30, -4.63, -6.75]},
                                   {"point": [0, 7, 0]}, {"point": [0, -7, 0]},
                                   {"point": [30, 4.63, -6.75]}, {"point": [30, -4.63, -6.75]}]})",
                      {"--plane", "0.1", "0.05", "1", "-1"});
}

TEST_F(PinsCommands, PinsWorkWithoutAPlane) {
    expectPinsInPlane(
        R"({"pins": [{"point": [-36, 0, -9.7]}, {"point": [0, 1, 0]}, {"point": [36, 0, -9.7]}]})", {});
}

TEST_F(PinsCommands, PinsAndWeightsOfAFileThatCannotBeUsedAreNamed) {
    const std::string part = bow(12);
    const std::vector<std::array<std::string, 3>> cases = {
        {"--pins", "{\"pins\": [", "byte"},
        {"--pins", "[1, 2]", "\"pins\""},
        {"--pins", R"({"pins": [{"point": [0, 0, 0]}, {"place": [0, 0, 0]}]})", "pin 2"},
        {"--pins", R"({"pins": [{"point": [0, 0, 500]}]})", "outside"},
        {"--weights", R"({"pins": []})", "\"regions\""},
        {"--weights", R"({"regions": [{"centre": [0, 0, 0], "radius": 5}]})", "weight"},
        {"--weights", R"({"regions": [{"centre": [0, 0, 0], "radius": -5, "weight": 2}]})", "radius"},
        {"--weights", R"({"regions": [{"centre": [0, 0, 0], "radius": 9, "weight": 2, "keep_within": "x"}]})",
         "keep_within"},
        {"--weights", R"({"regions": [{"faces": [0, 99999999], "weight": 2}]})", "faces"},
        {"--weights", R"({"regions": [{"centre": [900, 0, 0], "radius": 5, "weight": 2}]})", "no face"},
    };
    for (const auto& [option, text, named] : cases) {
        const std::string file = write("guide.json", text);
        const test::Run run = test::runProgram({"design", part, "--out", in("out"), option, file});
        EXPECT_EQ(run.exitCode, 3) << text;
        EXPECT_NE(run.err.find("guide.json"), std::string::npos) << run.err;
        EXPECT_NE(run.err.find(named), std::string::npos) << run.err;
    }
    const test::Run missing =
        test::runProgram({"design", part, "--out", in("out"), "--pins", in("nowhere.json")});
    EXPECT_EQ(missing.exitCode, 3);
    EXPECT_NE(missing.err.find("nowhere.json"), std::string::npos) << missing.err;
}

TEST_F(PinsCommands, EndsOfLimbsArePinnedOnAskingWhereThatHelps) {
    const std::vector<std::string> plain = {"design", test::samples() / "hand.ply", "--out", in("plain")};
    ASSERT_EQ(test::runProgram(plain).exitCode, 0);
    std::vector<std::string> asked = plain;
    asked[3] = in("auto");
    asked.insert(asked.end(), {"--pins", "auto"});
    ASSERT_EQ(test::runProgram(asked).exitCode, 0);
    const Json without = jsonIn("plain/design.json");
    const Json with = jsonIn("auto/design.json");
    EXPECT_EQ(with["plane"], without["plane"]);
    ASSERT_TRUE(with.contains("pins"));
    EXPECT_FALSE(with["pins"].empty());
    for (const Json& pin : with["pins"])
        EXPECT_LT(std::abs(pin["distance_from_plane"].get<double>()), 1e-4);
    EXPECT_LE(with["change"]["filled_volume_fraction"], without["change"]["filled_volume_fraction"]);
    // It has no limbs to pin.
    ASSERT_EQ(
        test::runProgram({"design", test::samples() / "praline.ply", "--out", in("none"), "--pins", "auto"})
            .exitCode,
        0);
    EXPECT_FALSE(jsonIn("none/design.json").contains("pins"));
}

TEST_F(PinsCommands, FramesAreTheShapesOnTheWay) {
    const std::string part = bow(16);
    ASSERT_EQ(test::runProgram({"design", part, "--out", in("out"), "--frames"}).exitCode, 0);
    const Json frames = jsonIn("out/frames/frames.json")["frames"];
    ASSERT_GT(frames.size(), 2U);
    EXPECT_EQ(frames[0]["file"], "0001.ply");
    EXPECT_LT(frames.back()["violating_area_fraction"].get<double>(),
              frames.front()["violating_area_fraction"].get<double>());
    for (const Json& frame : frames)
        EXPECT_TRUE(std::filesystem::exists(in("out/frames/" + frame["file"].get<std::string>())));
    ASSERT_EQ(test::runProgram({"design", part, "--out", in("plain")}).exitCode, 0);
    EXPECT_FALSE(std::filesystem::exists(in("plain/frames")));
}

TEST_F(PinsCommands, AnEyePaintedFourTimesKeepsItsShape) {
    // The front of the eyeball, which faces its half; the lid about it is undercut.
    const auto strainWith = [&](int weight) {
        const std::string out = in("weight-" + std::to_string(weight));
        const std::string weights =
            write("weights.json", R"({"regions": [{"name": "eye", "centre": [9.69, -18.45, 43.36],
                  "radius": 3.23, "weight": )" +
                                      std::to_string(weight) + "}]}");
        EXPECT_EQ(test::runProgram({"design", test::samples() / "goat_head.ply", "--size", "80", "--out", out,
                                    "--weights", weights})
                      .exitCode,
                  0);
        return jsonIn("weight-" + std::to_string(weight) + "/design.json")["regions"][0]["strain_rms"]
            .get<double>();
    };
    const double plain = strainWith(1);
    EXPECT_GT(plain, 0.05) << "something is there to be kept";
    EXPECT_LT(strainWith(16), plain / 2);
}

TEST_F(PinsCommands, WeightsChangeTheDesignAndTheirRegionsAreMeasured) {
    const std::string part = bow(16);
    const std::vector<std::string> plain = {"design", part,  "--out", in("plain"), "--plane",
                                            "0",      "0.3", "1",     "-3"};
    ASSERT_EQ(test::runProgram(plain).exitCode, 0);
    std::vector<std::string> weighted = plain;
    weighted[3] = in("weighted");
    weighted.insert(weighted.end(), {"--weights", write("weights.json", R"({"regions": [
                        {"name": "end", "centre": [36, 0, -13], "radius": 12, "weight": 64,
                         "keep_within": 1e-6}]})")});
    ASSERT_EQ(test::runProgram(weighted).exitCode, 0);
    const Json design = jsonIn("weighted/design.json");
    EXPECT_NE(jsonIn("plain/design.json")["strain"], design["strain"]);
    EXPECT_FALSE(jsonIn("plain/design.json").contains("regions"));
    ASSERT_EQ(design["regions"].size(), 1U);
    EXPECT_EQ(design["regions"][0]["name"], "end");
    EXPECT_GT(design["regions"][0]["max_distance"].get<double>(), 1e-6);
    EXPECT_EQ(design["regions"][0]["kept"], false);
}

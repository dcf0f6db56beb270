// SPDX-License-Identifier: AGPL-3.0-or-later
// The commands `verify`, `mold` and `info`, by running the real program.
#include "castability/certificate.h"
#include "cli/run_program.h"
#include "exchange/mesh_file.h"
#include "project/edits.h"
#include "project/project_file.h"
#include "project/variants.h"
#include "support/casts.h"
#include "support/folders.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

using namespace moldwright;
using Json = nlohmann::ordered_json;

namespace {

class MoldCommands : public testing::Test {
protected:
    std::string in(const std::string& name) const { return m_folder.path() / name; }

    /// A project whose cast is the part itself.
    std::string project(const test::KnownCast& cast) const {
        const auto mesh = std::make_shared<const IndexedMesh>(cast.mesh);
        Project whole = withPart({}, "Box", "box.stl", mesh, {});
        DesignResult result;
        result.cast = mesh;
        result.labels = labelSides(cast.mesh, cast.state.plane);
        result.state = cast.state;
        EXPECT_TRUE(saveProject(in("project.moldwright"), {withCast(whole, result, 1), "", ""}));
        return in("project.moldwright");
    }

    /// The same part in two variants, "flat" and then "tall" with a thicker wall; "flat" is the current one.
    std::string twoVariants(const test::KnownCast& cast) const {
        Project whole = openProject(project(cast)).value().project;
        whole = withVariantName(withDuplicate(withVariantName(whole, 0, "flat"), 0), 1, "tall");
        MoldSettings settings = whole.mold;
        settings.wall = 9;
        whole = withVariant(withMoldSettings(whole, settings), 0);
        EXPECT_TRUE(saveProject(in("two.moldwright"), {whole, "", ""}));
        return in("two.moldwright");
    }

    /// Verifies the files of a mold in the folder "out", in the directions that its JSON tells.
    test::Run verified(const Json& mold) const {
        std::vector<std::string> words = {"verify",
                                          in("out/mold-cast.stl"),
                                          "--plane",
                                          "0",
                                          "0",
                                          "1",
                                          "0",
                                          "--half1",
                                          in("out/mold-half-1.stl"),
                                          "--half2",
                                          in("out/mold-half-2.stl"),
                                          "--json",
                                          "-"};
        for (const char* d : {"d1", "d2"}) {
            words.push_back(std::string("--") + d);
            for (const Json& x : mold[d])
                words.push_back(x.dump());
        }
        return test::runProgram(words);
    }

    test::ScratchFolder m_folder;
    test::KnownCast m_box = test::frusta(20, 10, 5, 3, 0.1);
};

} // namespace

TEST_F(MoldCommands, VerifySaysYesOfACast) {
    ASSERT_TRUE(writeMesh(in("box.stl"), m_box.mesh, MeshFormat::StlBinary));
    const test::Run run = test::runProgram(
        {"verify", in("box.stl"), "--plane", "0", "0", "2", "0", "--draft", "5", "--json", "-"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["castable"], true);
    EXPECT_NEAR(json["worst_draft_deg"].get<double>(), degrees(std::atan(0.1)), 1e-4);
    EXPECT_EQ(json["violating_faces"], 0);
    EXPECT_EQ(json["parting_curves_simple"], true);
}

TEST_F(MoldCommands, VerifySaysNoOfTooLittleDraft) {
    ASSERT_TRUE(writeMesh(in("box.stl"), m_box.mesh, MeshFormat::StlBinary));
    const test::Run run = test::runProgram(
        {"verify", in("box.stl"), "--plane", "0", "0", "1", "0", "--draft", "6", "--json", "-"});
    EXPECT_EQ(run.exitCode, 1) << run.err;
    EXPECT_EQ(Json::parse(run.out)["violating_faces"], 16);
}

TEST_F(MoldCommands, VerifyNeedsAPlaneWithANormal) {
    ASSERT_TRUE(writeMesh(in("box.stl"), m_box.mesh, MeshFormat::StlBinary));
    EXPECT_EQ(test::runProgram({"verify", in("box.stl")}).exitCode, 2);
    EXPECT_EQ(test::runProgram({"verify", in("box.stl"), "--plane", "0", "0", "0", "1"}).exitCode, 2);
    EXPECT_EQ(test::runProgram({"verify", in("no.stl"), "--plane", "0", "0", "1", "0"}).exitCode, 3);
}

TEST_F(MoldCommands, MoldWritesHalvesThatVerify) {
    const std::string file =
        project(test::moved(test::sheared(m_box, 0.05, -0.03), {1, 2, 3}, 0.4, {3, 4, 5}));
    const test::Run run = test::runProgram({"mold", file, "--out", in("out"), "--wall", "7", "--json", "-"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["verified"], true);
    EXPECT_GE(json["min_wall"].get<double>(), 7 - 1e-6);
    const test::Run proof = verified(json);
    EXPECT_EQ(proof.exitCode, 0) << proof.err << proof.out;
    EXPECT_EQ(Json::parse(proof.out)["halves"][1]["free_to_move"], true);
}

TEST_F(MoldCommands, PlacesComeFromAMoldsOwnList) {
    const std::string file = project(test::frusta(50, 50, 8, 6, 0.1));
    const std::vector<std::string> words = {"mold", file, "--out", in("out"), "--keys", "2", "--json", "-"};
    const test::Run found = test::runProgram(words);
    ASSERT_EQ(found.exitCode, 0) << found.err;
    Json mold = Json::parse(found.out);
    const auto key = [](Json& json) -> Json& {
        return *std::find_if(json["features"].begin(), json["features"].end(),
                             [](const Json& feature) { return feature["kind"] == "key"; });
    };
    EXPECT_EQ(key(mold)["by_hand"], false);
    key(mold)["at"] = {-33.5, 4};
    std::ofstream(in("places.json")) << mold.dump();
    const auto placed = [&](const std::string& places) {
        std::vector<std::string> more = words;
        more.insert(more.end(), {"--places", places});
        return test::runProgram(more);
    };
    const test::Run moved = placed(in("places.json"));
    ASSERT_EQ(moved.exitCode, 0) << moved.err;
    Json after = Json::parse(moved.out);
    EXPECT_EQ(key(after)["number"], 1);
    EXPECT_EQ(key(after)["by_hand"], true);
    EXPECT_EQ(key(after)["place"], Json({-33.5, 4.0, 0.0}));
    key(mold)["at"] = {0, 0};
    std::ofstream(in("places.json")) << mold.dump();
    const test::Run refused = placed(in("places.json"));
    EXPECT_EQ(refused.exitCode, 4);
    EXPECT_NE(refused.err.find("Key 1"), std::string::npos) << refused.err;
    EXPECT_EQ(placed(in("none.json")).exitCode, 3);
    EXPECT_EQ(placed("auto").exitCode, 0);
}

TEST_F(MoldCommands, CavitiesStandOnACircleOrWhereTheyArePut) {
    const std::string file = project(m_box);
    const auto built = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = {"mold", file, "--out", in("out"), "--json", "-"};
        words.insert(words.end(), more.begin(), more.end());
        return test::runProgram(words);
    };
    const test::Run circle =
        built({"--layout", "circle", "--cavities", "5", "--spout", "auto", "--vents", "auto"});
    ASSERT_EQ(circle.exitCode, 0) << circle.err;
    const Json paths = Json::parse(circle.out)["path_lengths"];
    ASSERT_EQ(paths.size(), 5U);
    for (const Json& path : paths)
        EXPECT_NEAR(path.get<double>(), paths[0].get<double>(), 0.01);
    EXPECT_EQ(verified(Json::parse(circle.out)).exitCode, 0);
    const test::Run free = built({"--cavity-places", "0,0; 40,5,90"});
    ASSERT_EQ(free.exitCode, 0) << free.err;
    const Json mold = Json::parse(free.out);
    Json cavities = Json::array();
    for (const Json& feature : mold["features"])
        if (feature["kind"] == "cavity")
            cavities.push_back(feature);
    ASSERT_EQ(cavities.size(), 2U);
    EXPECT_NEAR(cavities[1]["turn_deg"].get<double>(), 90, 1e-9);
    EXPECT_NEAR(cavities[1]["place"][0].get<double>() - cavities[0]["place"][0].get<double>(), 40, 0.01);
    EXPECT_EQ(built({"--cavity-places", "0,0; 11,0"}).exitCode, 4);
    EXPECT_EQ(built({"--cavity-places", "0,0; 40"}).exitCode, 2);
    EXPECT_EQ(built({"--cavity-places", "0,0", "--cavities", "2"}).exitCode, 2);
}

TEST_F(MoldCommands, RunnersMayBeEquallyLong) {
    const std::string file = project(m_box);
    const auto built = [&](const std::string& cavities) {
        return test::runProgram({"mold", file, "--out", in("out"), "--cavities", cavities, "--spout", "auto",
                                 "--vents", "auto", "--runners", "balanced", "--json", "-"});
    };
    const test::Run grid = built("2x4");
    ASSERT_EQ(grid.exitCode, 0) << grid.err;
    const Json paths = Json::parse(grid.out)["path_lengths"];
    ASSERT_EQ(paths.size(), 8U);
    for (const Json& path : paths)
        EXPECT_NEAR(path.get<double>(), paths[0].get<double>(), 1e-9);
    EXPECT_EQ(verified(Json::parse(grid.out)).exitCode, 0);
    const test::Run refused = built("3x2");
    EXPECT_EQ(refused.exitCode, 4);
    EXPECT_NE(refused.err.find("power of two"), std::string::npos) << refused.err;
}

TEST_F(MoldCommands, HalvesSwappedDoNotVerify) {
    const std::string file = project(m_box);
    ASSERT_EQ(test::runProgram({"mold", file, "--out", in("out")}).exitCode, 0);
    const test::Run proof =
        test::runProgram({"verify", in("out/mold-cast.stl"), "--plane", "0", "0", "1", "0", "--half1",
                          in("out/mold-half-2.stl"), "--half2", in("out/mold-half-1.stl"), "--json", "-"});
    EXPECT_EQ(proof.exitCode, 1);
    EXPECT_EQ(Json::parse(proof.out)["castable"], true);
    EXPECT_EQ(Json::parse(proof.out)["halves"][0]["free_to_move"], false);
}

TEST_F(MoldCommands, MoldTakesAFolderAndNeedsACast) {
    project(m_box);
    EXPECT_EQ(test::runProgram({"mold", m_folder.path(), "--out", in("out")}).exitCode, 0);
    ASSERT_TRUE(saveProject(in("empty.moldwright"), {}));
    const test::Run run = test::runProgram({"mold", in("empty.moldwright"), "--out", in("out")});
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_NE(run.err.find("holds no finished cast"), std::string::npos);
}

TEST_F(MoldCommands, MoldWithAllItsFeaturesVerifies) {
    // Both directions lean more than 15° off the normal.
    const std::string file =
        project(test::moved(test::sheared(test::ball(12, 4), 0.3, 0.35), {1, 2, 3}, 0.4, {3, 4, 5}));
    const test::Run run = test::runProgram(
        {"mold",    file,    "--out",         in("out"), "--cavities",       "2x2",
         "--spout", "auto",  "--vents",       "auto",    "--keys",           "4",
         "--slits", "2",     "--shrink",      "1.5",     "--shrink-formula", "plus",
         "--block", "shell", "--outer-draft", "3",       "--also",           "obj,ply,svg,dxf",
         "--json",  "-"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["verified"], true);
    EXPECT_EQ(json["cavities"], 4);
    EXPECT_NEAR(json["shrink"]["factors"][0].get<double>(), 1.015, 1e-12);
    EXPECT_EQ(json["path_lengths"].size(), 4U);
    EXPECT_EQ(json["features"][0]["outer_draft_deg"], 3);
    EXPECT_GT(json["features"][0]["saved_volume"].get<double>(), 0);
    EXPECT_GT(json["channel_volume"].get<double>(), 0);
    EXPECT_NEAR(json["half1"]["volume"].get<double>() + json["half2"]["volume"].get<double>() +
                    json["cavity_volume"].get<double>() + json["channel_volume"].get<double>() +
                    json["other_volume"].get<double>(),
                json["block_volume"].get<double>(), 1e-6 * json["block_volume"].get<double>());
    for (const char* name : {"mold-half-1.obj", "mold-cast.ply", "mold-plan.svg", "mold-section-x.dxf"})
        EXPECT_TRUE(std::filesystem::file_size(in(std::string("out/") + name)) > 200) << name;
    EXPECT_EQ(verified(json).exitCode, 0) << "the files as they were written";
}

TEST_F(MoldCommands, AMoldThatLiesFlatIsFilledThroughHalf1) {
    std::vector<std::string> words = {
        "mold", project(m_box), "--out", in("out"), "--spout", "through", "--neck", "3",         "--vents",
        "auto", "--hollow",     "1.5",   "--stock", "60,100",  "--json",  "-",      "--density", "1.2"};
    words.insert(words.end(), {"--overflow", "2", "--overflow-diameter", "5"});
    const test::Run run = test::runProgram(words);
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_TRUE(json["verified"]);
    EXPECT_EQ(std::ranges::count_if(json["features"],
                                    [](const Json& feature) {
                                        return feature["kind"] == "overflow" && feature["diameter"] == 5;
                                    }),
              2);
    EXPECT_GT(json["sprue_volume"], 0);
    EXPECT_GT(json["shot"]["hollow"]["mass_g"], 0);
    for (const int axis : {0, 1}) {
        const double size = json["half1"]["size"][axis];
        EXPECT_TRUE(std::abs(size - 60) < 1e-4 || std::abs(size - 100) < 1e-4) << size;
    }
    EXPECT_EQ(verified(json).exitCode, 0);
    EXPECT_EQ(test::runProgram({"mold", project(m_box), "--out", in("out"), "--stock", "20"}).exitCode, 4);
}

TEST_F(MoldCommands, PocketsAndPlaqueAreMadeAsAskedFor) {
    const std::string file = project(test::frusta(60, 40, 8, 6, std::tan(radians(5))));
    const test::Run run = test::runProgram({"mold",           file,   "--out",           in("out"),
                                            "--pockets",      "3",    "--pocket-shape",  "round",
                                            "--pocket-half",  "both", "--pocket-width",  "6",
                                            "--pocket-depth", "4",    "--plaque",        "auto",
                                            "--shrink",       "1.5",  "--plaque-height", "3.5",
                                            "--json",         "-"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["verified"], true);
    int pockets = 0;
    std::string texts;
    for (const Json& feature : json["features"]) {
        if (feature["kind"] == "pocket") {
            EXPECT_EQ(feature["depth"], 4);
            EXPECT_EQ(feature["number"], ++pockets);
        } else if (feature["kind"] == "plaque") {
            EXPECT_EQ(feature["letter_height"], 3.5);
            texts += feature["note"].get<std::string>() + ";";
        }
    }
    EXPECT_EQ(pockets, 3);
    EXPECT_EQ(texts, "Reads: Box | HALF 1 | SHRINK 1.5 %;Reads: Box | HALF 2 | SHRINK 1.5 %;");
    EXPECT_EQ(verified(json).exitCode, 0) << "the files as they were written";
    EXPECT_EQ(test::runProgram({"mold", file, "--out", in("out"), "--plaque", "A?"}).exitCode, 2);
    EXPECT_EQ(test::runProgram({"mold", file, "--out", in("out"), "--plaque", "A", "--plaque-height", "60"})
                  .exitCode,
              4);
    EXPECT_EQ(test::runProgram({"mold", file, "--out", in("out"), "--pockets", "1", "--pocket-depth", "30"})
                  .exitCode,
              4);
}

TEST_F(MoldCommands, OtherProgramsFindNoFaultInTheHalves) {
    if (std::system("command -v admesh > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "admesh is not installed";
    const std::string file = project(test::sheared(test::ball(12, 4), 0.3, 0.35));
    ASSERT_EQ(
        test::runProgram({"mold", file, "--out", in("out"), "--cavities", "1x2", "--spout", "auto", "--vents",
                          "auto", "--keys", "4", "--slits", "2", "--bolts", "4", "--ejectors", "2"})
            .exitCode,
        0);
    for (const char* half : {"1", "2"}) {
        const std::string command = "admesh '" + in(std::string("out/mold-half-") + half + ".stl") + "' > '" +
                                    in("admesh.txt") + "' 2>&1";
        ASSERT_EQ(std::system(command.c_str()), 0);
        std::ifstream report(in("admesh.txt"));
        const std::string text{std::istreambuf_iterator<char>(report), {}};
        for (const char* fault : {"Degenerate facets", "Edges fixed", "Facets removed", "Facets added",
                                  "Facets reversed", "Backwards edges"}) {
            const std::size_t at = text.find(fault);
            ASSERT_NE(at, std::string::npos) << fault;
            EXPECT_EQ(std::atoi(text.c_str() + text.find(':', at) + 1), 0) << fault;
        }
    }
}

TEST_F(MoldCommands, MoldRefusesWhatCannotBe) {
    const std::string oblique = project(test::sheared(test::ball(12, 4), 0.3, 0.35));
    const test::Run turned =
        test::runProgram({"mold", oblique, "--out", in("out"), "--cavities", "1x2", "--alternate", "turn"});
    EXPECT_EQ(turned.exitCode, 4);
    EXPECT_NE(turned.err.find("cannot be turned"), std::string::npos);
    EXPECT_EQ(test::runProgram({"mold", oblique, "--out", in("out"), "--cavities", "2y2"}).exitCode, 2);
    EXPECT_EQ(test::runProgram({"mold", oblique, "--out", in("out"), "--vents", "auto"}).exitCode, 2);
    EXPECT_EQ(test::runProgram({"mold", oblique, "--out", in("out"), "--shrink", "70"}).exitCode, 2);
    EXPECT_EQ(test::runProgram({"mold", oblique, "--out", in("out"), "--pour-tilt", "steep"}).exitCode, 2);
    EXPECT_EQ(test::runProgram({"mold", oblique, "--out", in("out"), "--material", "gold"}).exitCode, 2);
}

TEST_F(MoldCommands, TheMoldLeansWhileItIsFilled) {
    const test::Run run = test::runProgram({"mold", project(m_box), "--out", in("out"), "--spout", "auto",
                                            "--pour-tilt", "20", "--pour-towards", "90", "--json", "-"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_TRUE(json["verified"]);
    const Json& tilt = json["pour_tilt"];
    EXPECT_EQ(tilt["towards"], "half 1");
    EXPECT_TRUE(tilt["applied"]);
    EXPECT_NEAR(tilt["up"][2].get<double>(), -std::sin(radians(20)), 1e-12);
    EXPECT_GT(tilt["trapped_air"].get<double>(), tilt["trapped_air_upright"].get<double>())
        << "a box is best filled upright";
}

TEST_F(MoldCommands, AMaterialBringsItsShrinkAndDensity) {
    const test::Run run =
        test::runProgram({"mold", project(m_box), "--out", in("out"), "--material", "pp", "--json", "-"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_NEAR(json["shrink"]["percent"][2].get<double>(), 1.6, 1e-12);
    EXPECT_NEAR(json["shot"]["mass_g"].get<double>(), 0.905 * json["shot"]["volume_cm3"].get<double>(), 1e-9);
    EXPECT_NE(json["notes"][0].get<std::string>().find("charts"), std::string::npos) << "the source is told";
    EXPECT_EQ(json["material"]["name"], "Polypropylene");
    const test::Run own = test::runProgram(
        {"mold", project(m_box), "--out", in("out"), "--material", "pp", "--shrink", "2.5", "--json", "-"});
    const Json changed = Json::parse(own.out);
    EXPECT_EQ(changed["shrink"]["percent"][0], 2.5) << "options go first";
    EXPECT_NE(changed["notes"][0].get<std::string>().find("set otherwise"), std::string::npos);
}

TEST_F(MoldCommands, InfoShowsTheManifest) {
    const test::Run run = test::runProgram({"info", project(m_box), "--json", "-"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["name"], "Box");
    EXPECT_EQ(json["cast"]["faces"], 20);
    EXPECT_EQ(test::runProgram({"info", in("missing.moldwright")}).exitCode, 3);
}

TEST_F(MoldCommands, InfoListsVariantsAndMeasuresTheOneNamed) {
    const std::string file = twoVariants(test::frusta(20, 10, 5, 3, 0.1));
    const Json plain = Json::parse(test::runProgram({"info", file, "--json", "-"}).out);
    ASSERT_EQ(plain["variants"].size(), 2U);
    EXPECT_EQ(plain["variants"][0]["name"], "flat");
    EXPECT_EQ(plain["variants"][0]["current"], true);
    EXPECT_FALSE(plain.contains("variant"));
    const Json tall = Json::parse(test::runProgram({"info", file, "--variant", "tall", "--json", "-"}).out);
    EXPECT_EQ(tall["variant"]["name"], "tall");
    EXPECT_EQ(tall["variant"]["figures"]["castable"], true);
    const Json flat = Json::parse(test::runProgram({"info", file, "--variant", "flat", "--json", "-"}).out);
    EXPECT_GT(tall["variant"]["figures"]["block"][0], flat["variant"]["figures"]["block"][0]);
    // One variant is told as it ever was.
    const Json one =
        Json::parse(test::runProgram({"info", project(test::frusta(20, 10, 5, 3, 0.1)), "--json", "-"}).out);
    EXPECT_FALSE(one.contains("variants"));
}

TEST_F(MoldCommands, BuildTheVariantNamed) {
    const std::string file = twoVariants(test::frusta(20, 10, 5, 3, 0.1));
    const auto width = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = {"mold", file, "--out", in("out"), "--json", "-"};
        words.insert(words.end(), more.begin(), more.end());
        const test::Run run = test::runProgram(words);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return Json::parse(run.out)["half1"]["size"][0].get<double>();
    };
    EXPECT_EQ(width({}), width({"--variant", "flat"}));
    EXPECT_EQ(width({"--variant", "tall"}), width({}) + 8);
    const test::Run none = test::runProgram({"mold", file, "--out", in("out"), "--variant", "wide"});
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_NE(none.err.find("It has: flat, tall."), std::string::npos) << none.err;
}

// SPDX-License-Identifier: AGPL-3.0-or-later
// The commands `plane`, `analyze` and `design`, by running the real program on bundled samples.
#include "castability/certificate.h"
#include "cli/run_program.h"
#include "exchange/mesh_file.h"
#include "support/folders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <numbers>
#include <set>
#include <sstream>

using namespace moldwright;
using Json = nlohmann::ordered_json;

namespace {

std::string contentsOf(const std::filesystem::path& file) {
    std::ostringstream bytes;
    bytes << std::ifstream(file, std::ios::binary).rdbuf();
    return bytes.str();
}

Eigen::Vector3d vectorOf(const Json& json) {
    return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

MoldState stateOf(const Json& json) {
    return {{vectorOf(json["plane"]), json["plane"][3].get<double>()},
            {vectorOf(json["d1"]), vectorOf(json["d2"])}};
}

std::string sample(const std::string& name) {
    return test::samples() / (name + ".ply");
}

class DesignCommands : public testing::Test {
protected:
    std::string in(const std::string& name) const { return m_folder.path() / name; }
    std::string write(const std::string& name, const IndexedMesh& mesh) const {
        EXPECT_TRUE(writeMesh(in(name), mesh, MeshFormat::Ply));
        return in(name);
    }
    /// A ring that stands on the plane z = 0, whole on side 1 but for its foot.
    std::string standingRing() const {
        return write("ring.ply", test::rotated(test::torus(20, 5, 40, 16), Eigen::Vector3d::UnitX(),
                                               std::numbers::pi / 2));
    }

    test::ScratchFolder m_folder;
};

} // namespace

TEST_F(DesignCommands, AMaterialAsksForItsDraft) {
    const auto draftWith = [this](const std::vector<std::string>& more) {
        std::vector<std::string> words = {"design", sample("praline"), "--out", in("p"), "--json", "-"};
        words.insert(words.end(), more.begin(), more.end());
        const test::Run run = test::runProgram(words);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return Json::parse(run.out)["draft_deg"].get<double>();
    };
    EXPECT_EQ(draftWith({"--material", "concrete"}), 8);
    EXPECT_EQ(draftWith({"--material", "concrete", "--draft", "2"}), 2);
    EXPECT_EQ(
        test::runProgram({"design", sample("praline"), "--out", in("p"), "--material", "gold"}).exitCode, 2);
}

TEST_F(DesignCommands, PlaneListsTheBestFirst) {
    const test::Run run = test::runProgram({"plane", sample("praline"), "--count", "3", "--json", "-"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Json planes = Json::parse(run.out)["planes"];
    ASSERT_EQ(planes.size(), 3U);
    for (const Json& plane : planes) {
        for (const char* key : {"plane", "d1", "d2", "energy", "violating_area_fraction", "worst_draft_deg"})
            EXPECT_TRUE(plane.contains(key)) << key;
        const MoldState state = stateOf(plane);
        EXPECT_NEAR(state.plane.normal.norm(), 1, 1e-12);
        EXPECT_GT(state.directions.d1.dot(state.plane.normal), 0);
        EXPECT_LT(state.directions.d2.dot(state.plane.normal), 0);
    }
    // Its flat back: side 2 is a plate.
    EXPECT_EQ(planes[0]["violating_area_fraction"], 0);
    EXPECT_NEAR(planes[0]["plane"][2].get<double>(), 1, 1e-9);
    EXPECT_NEAR(planes[0]["plane"][3].get<double>(), 0, 1e-9);
}

TEST_F(DesignCommands, AnalyzeSaysYesAndNo) {
    const test::Run yes =
        test::runProgram({"analyze", sample("praline"), "--plane", "0", "0", "1", "0", "--json", "-"});
    EXPECT_EQ(yes.exitCode, 0) << yes.err;
    const Json good = Json::parse(yes.out);
    EXPECT_EQ(good["castable"], true);
    EXPECT_EQ(good["undercuts"].size(), 0U);
    EXPECT_GE(good["worst_draft_deg"].get<double>(), 1);

    const test::Run no = test::runProgram({"analyze", sample("praline"), "--plane", "1", "0", "0", "0",
                                           "--d1", "1", "0", "0", "--d2", "-1", "0", "0", "--json", "-"});
    EXPECT_EQ(no.exitCode, 1) << no.err;
    const Json bad = Json::parse(no.out);
    EXPECT_EQ(bad["castable"], false);
    EXPECT_GT(bad["violating_area_fraction"].get<double>(), 0);
    ASSERT_GT(bad["undercuts"].size(), 0U);
    for (const char* key : {"area", "depth", "faces"})
        EXPECT_TRUE(bad["undercuts"][0].contains(key)) << key;
    double whole = 0;
    for (const Json& share : bad["draft_histogram"])
        whole += share["area_fraction"].get<double>();
    EXPECT_NEAR(whole, 1, 1e-9);
}

TEST_F(DesignCommands, WrongUsageIsToldApart) {
    EXPECT_EQ(test::runProgram({"analyze", sample("praline")}).exitCode, 2);
    EXPECT_EQ(test::runProgram({"design", sample("praline")}).exitCode, 2);
    EXPECT_EQ(test::runProgram({"design", sample("praline"), "--out", in("o"), "--plane", "0", "0", "0", "1"})
                  .exitCode,
              2);
    EXPECT_EQ(test::runProgram({"design", in("none.ply"), "--out", in("o")}).exitCode, 3);
    EXPECT_FALSE(std::filesystem::exists(in("o")));
}

TEST_F(DesignCommands, DesignWritesACastWhoseProofHoldsOnTheFilesAsWritten) {
    const test::Run run =
        test::runProgram({"design", sample("door_knob"), "--out", in("knob"), "--json", "-"});
    ASSERT_EQ(run.exitCode, 0) << run.err << run.out;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json, Json::parse(contentsOf(in("knob/design.json"))));
    for (const char* key :
         {"version", "input", "castable", "plane", "d1", "d2", "draft_deg", "worst_draft_deg",
          "violating_area_fraction", "energy", "change", "tets", "plastic_steps", "local_global_iterations",
          "limbs", "obstructions", "certificate", "warnings"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["castable"], true);
    EXPECT_EQ(json["certificate"]["holds"], true);
    EXPECT_GE(json["worst_draft_deg"].get<double>(), 1);
    EXPECT_LT(json["change"]["mean_distance"].get<double>(), 0.02);
    const Json timings = Json::parse(contentsOf(in("knob/timings.json")));
    for (const char* key : {"load", "tetrahedralize", "plane", "directions_first", "arap_first",
                            "elastoplastic", "postprocess", "fill", "mold", "total"})
        EXPECT_TRUE(timings.contains(key)) << key;
    EXPECT_TRUE(std::filesystem::exists(in("knob/project.moldwright")));

    const MoldState state = stateOf(json);
    for (const char* file : {"knob/cast.ply", "knob/cast.stl"}) {
        const Result<ReadMesh> cast = readMesh(in(file));
        ASSERT_TRUE(cast) << cast.error().english();
        const Certificate proof = certify(cast->mesh, labelSides(cast->mesh, state.plane), state, 1);
        EXPECT_TRUE(proof.holds()) << file << ": " << proof.reason;
    }
}

TEST_F(DesignCommands, DesignGivesTheSameBytesForAnyNumberOfThreads) {
    for (const char* threads : {"1", "2"})
        ASSERT_EQ(test::runProgram({"design", sample("bent_beam"), "--out", in(threads), "--threads", threads,
                                    "--json", in(threads + std::string(".json"))})
                      .exitCode,
                  0);
    for (const char* file : {"cast.ply", "cast.stl", "design.json"}) {
        const std::string one = contentsOf(in("1") + "/" + file);
        EXPECT_FALSE(one.empty());
        EXPECT_EQ(one, contentsOf(in("2") + "/" + file)) << file;
    }
    EXPECT_EQ(contentsOf(in("1.json")), contentsOf(in("2.json")));
}

TEST_F(DesignCommands, DesignNamesWhatStandsInTheWay) {
    const test::Run run = test::runProgram(
        {"design", standingRing(), "--out", in("ring"), "--plane", "0", "0", "1", "-22", "--fill", "none"});
    EXPECT_EQ(run.exitCode, 4) << run.err;
    EXPECT_NE(run.err.find("handle"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("side 1"), std::string::npos) << run.err;
    const Json json = Json::parse(contentsOf(in("ring/design.json")));
    EXPECT_EQ(json["castable"], false);
    ASSERT_EQ(json["obstructions"].size(), 1U);
    EXPECT_EQ(json["obstructions"][0]["kind"], "handle");
    EXPECT_EQ(json["obstructions"][0]["place"].size(), 3U);
    EXPECT_FALSE(std::filesystem::exists(in("ring/cast.stl")));
    EXPECT_TRUE(std::filesystem::exists(in("ring/parted.ply")));
    std::set<std::string> kinds;
    for (const Json& remedy : json["obstructions"][0]["remedies"]) {
        kinds.insert(remedy["kind"]);
        EXPECT_NE(run.err.find(remedy["message"].get<std::string>()), std::string::npos) << remedy;
        if (remedy["kind"] == "plane") {
            std::vector<std::string> again{"design", standingRing(), "--out", in("moved"), "--fill",
                                           "none",   "--time-limit", "0.5",   "--plane"};
            for (const Json& x : remedy["plane"])
                again.push_back(x.dump());
            EXPECT_NE(test::runProgram(again).exitCode, 4) << "the plane suggested must serve";
        } else if (remedy["kind"] == "fill") {
            EXPECT_GT(remedy["volume"], 0);
            EXPECT_LT(remedy["volume_fraction"], 2);
            std::vector<std::string> again{"design", standingRing(), "--out", in("chosen"), "--fill",
                                           "none",   "--plane",      "0",     "0",          "1",
                                           "-22",    "--fill-at"};
            for (const Json& place : remedy["fill_at"])
                for (const Json& x : place)
                    again.push_back(x.dump());
            EXPECT_EQ(test::runProgram(again).exitCode, 0) << "what was chosen is filled";
        }
    }
    EXPECT_TRUE(kinds.contains("plane") && kinds.contains("fill"));
}

TEST_F(DesignCommands, DesignFillsWhatNoBendingFrees) {
    const test::Run run = test::runProgram(
        {"design", standingRing(), "--out", in("ring"), "--plane", "0", "0", "1", "-22", "--mold"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    const Json json = Json::parse(contentsOf(in("ring/design.json")));
    EXPECT_EQ(json["castable"], true);
    EXPECT_EQ(json["obstructions"].size(), 1U) << "what was filled is still told";
    EXPECT_GT(json["change"]["filled_volume_fraction"], 0.02);
    EXPECT_NE(run.out.find("Filled in: "), std::string::npos) << run.out;
    EXPECT_GT(json["change"]["volume_ratio"], 1.02);
    EXPECT_TRUE(std::filesystem::exists(in("ring/mold-half-1.stl")));
}

TEST_F(DesignCommands, ACastIsWrittenThoughItsMoldCannotBe) {
    const test::Run run = test::runProgram(
        {"design", sample("rabbit"), "--out", in("rabbit"), "--size", "80", "--mold", "--vents", "auto"});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_NE(run.err.find("Vents need a spout"), std::string::npos) << run.err;
    EXPECT_EQ(Json::parse(contentsOf(in("rabbit/design.json")))["castable"], true);
    EXPECT_TRUE(std::filesystem::exists(in("rabbit/project.moldwright")));
    EXPECT_FALSE(std::filesystem::exists(in("rabbit/mold.json")));
}

TEST_F(DesignCommands, DesignEndsWhenItsTimeIsOver) {
    const test::Run run =
        test::runProgram({"design", sample("goat"), "--out", in("goat"), "--time-limit", "0.2"});
    EXPECT_EQ(run.exitCode, 5) << run.err;
    EXPECT_NE(run.err.find("stopped before its end"), std::string::npos) << run.err;
    const Json json = Json::parse(contentsOf(in("goat/design.json")));
    EXPECT_EQ(json["cut_short"], true);
    EXPECT_EQ(json["castable"], false);
    EXPECT_TRUE(std::filesystem::exists(in("goat/project.moldwright")));
}

// SPDX-License-Identifier: AGPL-3.0-or-later
// The command line's frame and its command `check`, by running the real program.
#include "cli/run_program.h"
#include "exchange/mesh_file.h"
#include "support/folders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

#include <sys/stat.h>

using namespace moldwright;
using Json = nlohmann::ordered_json;

namespace {

class Check : public testing::Test {
protected:
    std::string write(const std::string& name, const IndexedMesh& mesh) {
        const auto file = m_folder.path() / name;
        EXPECT_TRUE(writeMesh(file, mesh, MeshFormat::Ply));
        return file;
    }
    std::string in(const std::string& name) { return m_folder.path() / name; }

    test::ScratchFolder m_folder;
    IndexedMesh m_ring = test::torus(3, 1, 20, 10);
};

IndexedMesh withHole(IndexedMesh mesh) {
    mesh.F.conservativeResize(mesh.F.rows() - 1, Eigen::NoChange);
    return mesh;
}

std::vector<std::string> keysOf(const Json& json) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items())
        keys.push_back(key);
    return keys;
}

const std::vector<std::string> keys = {
    "usable",     "vertices", "faces",  "closed", "manifold", "oriented", "self_intersections",
    "components", "genus",    "volume", "bbox",   "repairs",  "notes",    "problems"};

} // namespace

TEST_F(Check, ASoundPart) {
    const test::Run run = test::runProgram({"check", write("ring.ply", m_ring), "--json", "-"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    const Json json = Json::parse(run.out); // and nothing else went there
    EXPECT_EQ(keysOf(json), keys);
    EXPECT_EQ(json["usable"], true);
    EXPECT_EQ(json["vertices"], 200);
    EXPECT_EQ(json["faces"], 400);
    EXPECT_EQ(json["genus"], 1);
    EXPECT_EQ(json["components"], 1);
    EXPECT_EQ(json["self_intersections"], 0);
    EXPECT_EQ(json["bbox"][1][0], 4.0);
    EXPECT_TRUE(json["problems"].empty());
}

TEST_F(Check, APartWithAHole) {
    const test::Run run =
        test::runProgram({"check", write("open.ply", withHole(m_ring)), "--json", in("a.json")});
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_NE(run.err.find("The surface of open.ply has a hole, near ("), std::string::npos) << run.err;
    const Json json = Json::parse(std::ifstream(in("a.json")));
    EXPECT_EQ(json["usable"], false);
    EXPECT_EQ(json["closed"], false);
    EXPECT_TRUE(json["volume"].is_null());
    EXPECT_EQ(json["problems"].size(), 1U);
}

TEST_F(Check, AFileThatCannotBeRead) {
    const test::Run missing = test::runProgram({"check", in("nothing.stl"), "--json", "-"});
    EXPECT_EQ(missing.exitCode, 3);
    EXPECT_NE(missing.err.find("There is no file " + in("nothing.stl")), std::string::npos);
    EXPECT_EQ(Json::parse(missing.out)["usable"], false);
    std::ofstream(in("bad\xFFname.stl")) << "solid nothing\nendsolid\n";
    const test::Run odd = test::runProgram({"check", in("bad\xFFname.stl"), "--json", "-"});
    EXPECT_EQ(odd.exitCode, 3);
    EXPECT_EQ(Json::parse(odd.out)["problems"].size(), 1U); // legible whatever the name's bytes
}

TEST_F(Check, SaysWhatWasMended) {
    IndexedMesh turned = m_ring;
    turned.F.col(0).swap(turned.F.col(1));
    const test::Run run = test::runProgram({"check", write("turned.ply", turned)});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_NE(run.out.find("The surface was inside out and was turned."), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("turned.ply can be used: 200 points, 400 faces"), std::string::npos) << run.out;
}

TEST_F(Check, QuietSaysNothingWhenAllIsWell) {
    const test::Run run = test::runProgram({"check", write("ring.ply", m_ring), "--quiet"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.out + run.err, "");
}

TEST_F(Check, IsTheSameForAnyNumberOfThreads) {
    const std::string file = write("ring.ply", m_ring);
    const std::string one = test::runProgram({"check", file, "--json", "-", "--threads", "1"}).out;
    EXPECT_EQ(test::runProgram({"check", file, "--json", "-", "--threads", "2"}).out, one);
    EXPECT_EQ(test::runProgram({"check", file, "--json", "-", "--threads", "8"}).out, one);
}

TEST_F(Check, WrongUsage) {
    const std::string file = write("ring.ply", m_ring);
    EXPECT_EQ(test::runProgram({}).exitCode, 2);
    EXPECT_EQ(test::runProgram({"polish", file}).exitCode, 2);
    EXPECT_EQ(test::runProgram({"check"}).exitCode, 2);
    EXPECT_EQ(test::runProgram({"check", file, "--threads", "-1"}).exitCode, 2);
    EXPECT_EQ(test::runProgram({"check", file, "--time-limit", "soon"}).exitCode, 2);
    const test::Run zero = test::runProgram({"check", file, "--time-limit", "0"});
    EXPECT_EQ(zero.err, "moldwright-cli: --time-limit: 0 is not a number above 0.\n"
                        "moldwright-cli COMMAND --help tells what there is.\n");
    for (const std::vector<std::string>& half :
         {std::vector<std::string>{"--repair"}, std::vector<std::string>{"--out", in("b.ply")},
          std::vector<std::string>{"--repair", "--out", in("b.step")}}) {
        std::vector<std::string> words{"check", file};
        words.insert(words.end(), half.begin(), half.end());
        EXPECT_EQ(test::runProgram(words).exitCode, 2);
    }
}

TEST_F(Check, RepairsWhatCanBeRepaired) {
    const std::string broken = write("broken.ply", withHole(m_ring));
    for (const char* name : {"mended.stl", "mended.obj"}) {
        const test::Run run =
            test::runProgram({"check", broken, "--repair", "--out", in(name), "--json", "-"});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        const Json json = Json::parse(run.out);
        EXPECT_EQ(keysOf(json), keys);
        EXPECT_EQ(json["usable"], true);
        EXPECT_NE(json["repairs"][0].get<std::string>().find("1 holes were filled"), std::string::npos);
        EXPECT_EQ(test::runProgram({"check", in(name)}).exitCode, 0);
    }
    const std::string sheet = write("sheet.ply", {m_ring.V, m_ring.F.topRows(8)});
    const test::Run no = test::runProgram({"check", sheet, "--repair", "--out", in("no.ply"), "--json", "-"});
    EXPECT_EQ(no.exitCode, 3);
    EXPECT_EQ(Json::parse(no.out)["usable"], false);
    EXPECT_FALSE(std::filesystem::exists(in("no.ply")));
}

TEST_F(Check, HelpAndVersion) {
    const test::Run help = test::runProgram({"check", "--help"});
    EXPECT_EQ(help.exitCode, 0);
    for (const char* word :
         {"--json", "--threads", "--seed", "--time-limit", "--quiet", "Exit codes", "Example"})
        EXPECT_NE(help.out.find(word), std::string::npos) << word;
    EXPECT_EQ(test::runProgram({"--version"}).exitCode, 0);
}

TEST_F(Check, AnOutputThatCannotBeWrittenIsNamed) {
    const test::Run run =
        test::runProgram({"check", write("ring.ply", m_ring), "--json", in("nowhere/a.json")});
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_NE(run.err.find("nowhere/a.json could not be written: the folder does not exist."),
              std::string::npos);
}

TEST_F(Check, OutOfTime) {
    const test::Run run = test::runProgram({"check", write("ring.ply", m_ring), "--time-limit", "1e-9"});
    EXPECT_EQ(run.exitCode, 5);
    EXPECT_NE(run.err.find("Stopped before the end."), std::string::npos) << run.err;
}

TEST_F(Check, CtrlCStopsIt) {
    std::ofstream(in("worker")) << "#!/bin/sh\nexec sleep 100\n";
    std::filesystem::permissions(in("worker"), std::filesystem::perms::owner_all);
    setenv("MOLDWRIGHT_WORKER", in("worker").c_str(), 1); // NOLINT(concurrency-mt-unsafe)
    const test::Run run =
        test::runProgram({"check", write("ring.ply", m_ring)}, std::chrono::milliseconds(500));
    unsetenv("MOLDWRIGHT_WORKER"); // NOLINT(concurrency-mt-unsafe)
    EXPECT_EQ(run.exitCode, 5) << run.err;
    EXPECT_NE(run.err.find("Stopped before the end."), std::string::npos) << run.err;
}

TEST_F(Check, APipeIsRefusedAtOnce) {
    ASSERT_EQ(mkfifo(in("endless.stl").c_str(), 0600), 0);
    const test::Run run = test::runProgram({"check", in("endless.stl")});
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_NE(run.err.find("endless.stl is not a plain file."), std::string::npos) << run.err;
}

TEST_F(Check, TheRealModelsAreUsable) {
    if (!test::models())
        GTEST_SKIP() << "MOLDWRIGHT_MODELS is not set";
    int checked = 0;
    for (const auto& entry : std::filesystem::directory_iterator(*test::models())) {
        if (entry.path().extension() == ".md" || entry.path().extension() == ".json")
            continue;
        const test::Run run = test::runProgram({"check", entry.path()});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        ++checked;
    }
    EXPECT_GT(checked, 10);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
// `mold --with`: different parts in one mold, by running the real program.
#include "castability/certificate.h"
#include "cli/run_program.h"
#include "project/edits.h"
#include "project/further_parts.h"
#include "project/project_file.h"
#include "support/casts.h"
#include "support/folders.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

using namespace moldwright;
using Json = nlohmann::ordered_json;

namespace {

class MoldWith : public testing::Test {
protected:
    std::string in(const std::string& name) const { return m_folder.path() / name; }

    /// A folder as `design` writes it, whose cast is the part itself.
    std::string folderWith(const std::string& folder, const std::string& name,
                           const test::KnownCast& cast) const {
        const auto mesh = std::make_shared<const IndexedMesh>(cast.mesh);
        Project whole = withPart({}, name, name + ".stl", mesh, {});
        DesignResult result;
        result.cast = mesh;
        result.labels = labelSides(cast.mesh, cast.state.plane);
        result.state = cast.state;
        std::filesystem::create_directory(in(folder));
        EXPECT_TRUE(saveProject(in(folder + "/project.moldwright"), {withCast(whole, result, 1), "", ""}));
        return in(folder);
    }

    test::ScratchFolder m_folder;
    test::KnownCast m_box = test::frusta(20, 10, 5, 3, 0.1);
};

} // namespace

TEST_F(MoldWith, OtherPartsStandInTheSameMold) {
    const std::string ball = folderWith("ball", "ball", test::ball(6, 4));
    const std::string file = folderWith("first", "box", m_box);
    const auto built = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = {"mold", file, "--out", in("out"), "--json", "-"};
        words.insert(words.end(), more.begin(), more.end());
        return test::runProgram(words);
    };
    const test::Run pair = built({"--with", ball, "--with", file, "--spout", "auto", "--vents", "auto"});
    ASSERT_EQ(pair.exitCode, 0) << pair.err;
    const Json json = Json::parse(pair.out);
    EXPECT_EQ(json["verified"], true);
    EXPECT_EQ(json["cavities"], 3);
    EXPECT_EQ(json["parts"][1]["name"], "ball");
    EXPECT_EQ(json["parts"][2]["name"], "first") << "the name of the first is taken: the folder's";
    const test::Run proof =
        test::runProgram({"verify", in("out/mold-cast.stl"), "--plane", "0", "0", "1", "0", "--half1",
                          in("out/mold-half-1.stl"), "--half2", in("out/mold-half-2.stl")});
    EXPECT_EQ(proof.exitCode, 0) << proof.err << proof.out;
    const test::Run five = built({"--with", ball + ":3", "--cavities", "1x5", "--layout", "packed"});
    ASSERT_EQ(five.exitCode, 0) << five.err;
    EXPECT_EQ(Json::parse(five.out)["parts"][0]["cavities"], 2);
    EXPECT_EQ(Json::parse(five.out)["parts"][1]["cavities"], 3);
    // A folder may be called so.
    std::filesystem::rename(ball, ball + ":2");
    const test::Run two = built({"--with", ball + ":2"});
    ASSERT_EQ(two.exitCode, 0) << two.err;
    EXPECT_EQ(Json::parse(two.out)["parts"][1]["cavities"], 1);
    EXPECT_EQ(Json::parse(two.out)["parts"][1]["name"], "ball");
}

TEST_F(MoldWith, PartsThatCannotStandThereAreRefusedByTheirFolder) {
    const std::string oblique = folderWith("oblique", "steep", test::sheared(test::ball(6, 4), 0.4, 0.4));
    const std::string file = folderWith("first", "box", m_box);
    const auto refused = [&](const std::string& with, int exitCode) {
        const test::Run run = test::runProgram({"mold", file, "--with", with, "--out", in("out")});
        EXPECT_EQ(run.exitCode, exitCode) << run.err;
        EXPECT_FALSE(std::filesystem::exists(in("out")));
        return run.err;
    };
    EXPECT_NE(refused(oblique, 4).find(oblique), std::string::npos);
    EXPECT_NE(refused(in("none") + ":2", 3).find("--with " + in("none")), std::string::npos);
    ASSERT_TRUE(saveProject(in("empty.moldwright"), {}));
    EXPECT_NE(refused(in("empty.moldwright"), 3).find(in("empty.moldwright")), std::string::npos);
    EXPECT_NE(refused(oblique + ":0", 2).find(oblique), std::string::npos);
}

TEST_F(MoldWith, PartsThatTheProjectsMoldHasStandThereAndWithAddsToThem) {
    const std::string ball = folderWith("ball", "ball", test::ball(6, 4));
    const std::string file = folderWith("first", "box", m_box) + "/project.moldwright";
    const Project project = openProject(file)->project;
    TrayPart part = readTrayPart(ball, {"box"}).value();
    part.count = 2;
    ASSERT_TRUE(saveProject(file, {withFurtherPart(project, part), "", ""}));
    const auto parts = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = {"mold", file, "--out", in("out"), "--json", "-"};
        words.insert(words.end(), more.begin(), more.end());
        const test::Run run = test::runProgram(words);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        std::vector<std::string> told;
        const Json json = Json::parse(run.out);
        for (const Json& one : json["parts"])
            told.push_back(one["name"].get<std::string>() + one["cavities"].dump());
        return told;
    };
    EXPECT_EQ(parts({}), (std::vector<std::string>{"box1", "ball2"}));
    std::filesystem::rename(ball, in("gone")); // the project has all it needs of it
    EXPECT_EQ(parts({"--with", in("gone") + ":3"}), (std::vector<std::string>{"box1", "ball2", "gone3"}));
    const test::Run info = test::runProgram({"info", file, "--variant", "A", "--json", "-"});
    ASSERT_EQ(info.exitCode, 0) << info.err;
    const Json json = Json::parse(info.out);
    EXPECT_EQ(json["further_parts"], Json::parse(R"([{"name": "ball", "count": 2}])"));
    EXPECT_EQ(json["variant"]["further_parts"][0]["source"], ball);
}

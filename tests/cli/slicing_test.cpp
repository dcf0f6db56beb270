// SPDX-License-Identifier: AGPL-3.0-or-later
// Finished molds under the eyes of other programs: PrusaSlicer slices both halves and mends nothing, admesh
// finds no defect. Slow; skipped where these programs or the models are missing.
#include "castability/certificate.h"
#include "cli/run_program.h"
#include "project/edits.h"
#include "project/project_file.h"
#include "support/casts.h"
#include "support/folders.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>

using namespace moldwright;
using namespace moldwright::test;

namespace {

bool isInstalled(const std::string& program) {
    return std::system(("command -v " + program + " > /dev/null").c_str()) == 0;
}

/// What a command line of the shell says, on both outputs.
std::string saidBy(const std::string& words, int& exitCode) {
    FILE* pipe = popen((words + " 2>&1").c_str(), "r");
    std::string all;
    std::array<char, 4096> piece{};
    while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), pipe))
        all.append(piece.data(), count);
    exitCode = pclose(pipe);
    return all;
}

class Slicing : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        for (const char* program : {"prusa-slicer", "admesh"})
            if (!isInstalled(program))
                GTEST_SKIP() << program << " is not installed";
    }

    std::string in(const std::string& name) const { return m_folder.path() / name; }

    /// The mold of a project or a design's folder with every feature, proved.
    void buildMold(const std::string& input, const std::vector<std::string>& more) {
        std::vector<std::string> words = {
            "mold",    input, "--out",    in("mold"), "--quiet",          "--vents", "auto",    "--keys", "4",
            "--slits", "2",   "--shrink", "1.5",      "--shrink-formula", "plus",    "--bolts", "4"};
        words.insert(words.end(), more.begin(), more.end());
        const test::Run run = runProgram(words);
        ASSERT_EQ(run.exitCode, 0) << run.err;
    }

    void expectFlawless() {
        for (const char* half : {"mold-half-1", "mold-half-2"}) {
            const std::string file = in(std::string("mold/") + half + ".stl");
            int code = 0;
            const std::string checked = saidBy("admesh " + file, code);
            EXPECT_EQ(code, 0);
            for (const char* none : {"Total disconnected facets        :     0                   0",
                                     "Degenerate facets     :     0", "Facets removed        :     0",
                                     "Facets added          :     0", "Facets reversed       :     0",
                                     "Backwards edges       :     0", "Number of parts       :     1"})
                EXPECT_NE(checked.find(none), std::string::npos) << half << ": " << none << '\n' << checked;
            const std::string known = saidBy("prusa-slicer --info " + file, code);
            EXPECT_NE(known.find("manifold = yes"), std::string::npos) << known;
            std::string sliced =
                saidBy("prusa-slicer -g --bed-shape 0x0,900x0,900x900,0x900 --layer-height 0.3 -o " +
                           in("half.gcode") + " " + file,
                       code);
            EXPECT_EQ(code, 0) << sliced;
            EXPECT_NE(sliced.find("exported"), std::string::npos) << sliced;
            for (const char* word : {"epair", "open edge", "rror"})
                EXPECT_EQ(sliced.find(word), std::string::npos) << sliced;
        }
    }

    ScratchFolder m_folder;
};

} // namespace

TEST_F(Slicing, OfSmallCastsNeedsNoRepair) {
    const double lean = 0.1;
    int number = 0;
    for (const KnownCast& cast : {frusta(40, 20, 8, 5, lean), sheared(ball(15, 4), 0.35, -0.3)}) {
        const auto mesh = std::make_shared<const IndexedMesh>(cast.mesh);
        DesignResult result;
        result.cast = mesh;
        result.labels = labelSides(cast.mesh, cast.state.plane);
        result.state = cast.state;
        const std::string project = in("small" + std::to_string(++number) + ".moldwright");
        ASSERT_TRUE(saveProject(project,
                                {withCast(withPart({}, "Small", "small.stl", mesh, {}), result, 1), "", ""}));
        for (const char* spout : {"auto", "through"}) {
            ASSERT_NO_FATAL_FAILURE(buildMold(project, {"--spout", spout, "--cavities", "2x2"}));
            expectFlawless();
        }
    }
}

TEST_P(Slicing, OfADesignNeedsNoRepair) {
    const auto models = test::models();
    if (!models)
        GTEST_SKIP() << "MOLDWRIGHT_MODELS is not set";
    const test::Run designed =
        runProgram({"design", *models / GetParam(), "--out", in("design"), "--size", "80", "--quiet"});
    ASSERT_EQ(designed.exitCode, 0) << designed.err;
    for (const char* spout : {"auto", "through"}) {
        ASSERT_NO_FATAL_FAILURE(buildMold(in("design"), {"--spout", spout, "--cavities", "2x2"}));
        expectFlawless();
    }
}

INSTANTIATE_TEST_SUITE_P(Models, Slicing,
                         testing::Values("bunny.stl", "spot.obj", "goathead.stl", "lcd_knob.stl",
                                         "armadillo_15k.ply"));

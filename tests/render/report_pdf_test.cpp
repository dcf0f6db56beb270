// SPDX-License-Identifier: AGPL-3.0-or-later
// The picture program and the command `report`, by running the real programs without a display.
#include "castability/certificate.h"
#include "cli/run_program.h"
#include "language/core_words.h"
#include "language/spoken_language.h"
#include "project/edits.h"
#include "project/project_file.h"
#include "project/variants.h"
#include "render/job.h"
#include "render/pictures.h"
#include "render/report_text.h"
#include "scene/offscreen/picture.h"
#include "support/casts.h"
#include "support/folders.h"
#include "support/solids.h"

#include <QCoreApplication>
#include <QImage>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <iterator>

using namespace moldwright;
using Json = nlohmann::ordered_json;

namespace {

int redPixels(const std::filesystem::path& file) {
    const QImage image(QString::fromStdString(file.string()));
    int red = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            red += image.pixelColor(x, y).red() > 2 * image.pixelColor(x, y).green();
    return red;
}

class Report : public testing::Test {
protected:
    std::string in(const std::string& name) const { return m_folder.path() / name; }

    void SetUp() override {
        unsetenv("DISPLAY");         // NOLINT(concurrency-mt-unsafe)
        unsetenv("WAYLAND_DISPLAY"); // NOLINT(concurrency-mt-unsafe)
        const test::KnownCast cast = test::sheared(test::ball(20, 3), 0.1, 0);
        const auto mesh = std::make_shared<const IndexedMesh>(cast.mesh);
        DesignResult result;
        result.cast = mesh;
        result.labels = labelSides(cast.mesh, cast.state.plane);
        result.state = cast.state;
        ASSERT_TRUE(saveProject(in("ball.moldwright"),
                                {withCast(withPart({}, "Ball", "ball.stl", mesh, {}), result, 1), "", ""}));
    }

    static std::string bytesOf(const std::string& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    test::ScratchFolder m_folder;
};

} // namespace

TEST_F(Report, IsAPdfOfTwoPagesWithPictures) {
    const test::Run run =
        test::runProgram({"report", in("ball.moldwright"), "--out", in("ball.pdf"), "--json", "-"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["pages"], 2);
    EXPECT_EQ(json["missing_pictures"], "");
    const std::string pdf = bytesOf(in("ball.pdf"));
    EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
    EXPECT_NE(pdf.find("/Count 2"), std::string::npos);
    EXPECT_NE(pdf.find("/Subtype /Image"), std::string::npos);
}

TEST_F(Report, ComesInAnotherLanguageWhereAsked) {
    const auto pageText = [&](const char* language) {
        const test::Run run = test::runProgram(
            {"report", in("ball.moldwright"), "--out", in("ball.pdf"), "--language", language});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return bytesOf(in("ball.pdf"));
    };
    EXPECT_NE(pageText("en").size(), pageText("de").size());
    EXPECT_EQ(test::runProgram({"report", in("ball.moldwright"), "--out", in("x.pdf"), "--language", "xx"})
                  .exitCode,
              2);
}

TEST_F(Report, OfSeveralVariantsHasAPageThatComparesThem) {
    Project project = openProject(in("ball.moldwright")).value().project;
    project = withDuplicate(withDuplicate(project, 0), 0); // A, C, B
    project.cast = nullptr;                                // of C
    ASSERT_TRUE(saveProject(in("two.moldwright"), {project, "", ""}));
    for (const char* variant : {"A", "C"}) {
        const test::Run run = test::runProgram(
            {"report", in("two.moldwright"), "--variant", variant, "--out", in("two.pdf"), "--json", "-"});
        ASSERT_EQ(run.exitCode, 0) << run.err;
        EXPECT_EQ(Json::parse(run.out)["pages"], 3);
    }
    const test::Run none = test::runProgram(
        {"report", in("two.moldwright"), "--variant", "Z", "--out", in("none.pdf"), "--json", "-"});
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_NE(none.err.find("A, C, B"), std::string::npos) << none.err;
}

TEST_F(Report, WithoutGraphicsComesWithoutPictures) {
    setenv("LIBGL_DRIVERS_PATH", "/nowhere", 1);             // NOLINT(concurrency-mt-unsafe)
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere", 1); // NOLINT(concurrency-mt-unsafe)
    const test::Run run =
        test::runProgram({"report", in("ball.moldwright"), "--out", in("ball.pdf"), "--json", "-"});
    unsetenv("LIBGL_DRIVERS_PATH");             // NOLINT(concurrency-mt-unsafe)
    unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES"); // NOLINT(concurrency-mt-unsafe)
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(Json::parse(run.out)["pages"], 2);
    EXPECT_NE(Json::parse(run.out)["missing_pictures"], "");
    EXPECT_EQ(bytesOf(in("ball.pdf")).find("/Subtype /Image"), std::string::npos);
}

TEST_F(Report, OfAMissingProjectIsRefusedByName) {
    const test::Run run = test::runProgram({"report", in("none.moldwright"), "--out", in("none.pdf")});
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_NE(run.err.find("none.moldwright"), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(in("none.pdf")));
}

TEST_F(Report, ThatCannotBeWrittenKeepsTheOldOne) {
    const test::Run run =
        test::runProgram({"report", in("ball.moldwright"), "--out", in("no/such/folder.pdf")});
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_NE(run.err.find("could not be written"), std::string::npos) << run.err;
}

TEST(SurfaceJob, ReadsAMeshAndHowItIsToLook) {
    const Result<render::Job> job =
        render::readJob(R"({"task": "surface", "mesh": "a.stl", "plane": [0, 0, 1, 2.5], "d1": [0, 0.6, 0.8],
                            "d2": [0, 0, -1], "draft": 3, "from": [0, -1, 0], "see_through": true,
                            "pins": [[1, 2, 3]], "suggested": [[4, 5, 6], [7, 8, 9]], "width": 90,
                            "out": "a.png"})");
    ASSERT_TRUE(job.has_value());
    EXPECT_EQ(job->source, "a.stl");
    ASSERT_TRUE(job->look.state.has_value());
    EXPECT_EQ(job->look.state->plane.offset, 2.5);
    EXPECT_EQ(job->look.state->directions.d1, Eigen::Vector3d(0, 0.6, 0.8));
    EXPECT_EQ(job->look.draftDegrees, 3);
    EXPECT_EQ(job->look.from, Eigen::Vector3d(0, -1, 0));
    EXPECT_TRUE(job->look.seeThrough);
    EXPECT_EQ(job->look.pins, std::vector<Eigen::Vector3d>{Eigen::Vector3d(1, 2, 3)});
    EXPECT_EQ(job->look.suggested.size(), 2U);
    EXPECT_EQ(job->look.width, 90);
    EXPECT_FALSE(render::readJob(R"({"task": "surface", "mesh": "a", "plane": [0, 0], "out": "b"})"));
}

TEST(SurfacePicture, ShowsRedWhereAFaceIsUndercut) {
    if (!scene::EglContext::create())
        GTEST_SKIP() << "no graphics";
    const test::ScratchFolder folder;
    const auto ball = std::make_shared<const IndexedMesh>(test::sheared(test::ball(20, 3), 0, 0).mesh);
    const auto redIn = [&](const SharedMesh& mesh, std::optional<double> offset) {
        render::SurfaceLook look;
        look.width = look.height = 100;
        look.draftDegrees = 0;
        if (offset)
            look.state = MoldState{{Eigen::Vector3d::UnitZ(), *offset},
                                   {Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitZ()}};
        const std::filesystem::path file = folder.path() / "map.png";
        EXPECT_TRUE(render::drawSurface(mesh, look, file));
        return redPixels(file);
    };
    EXPECT_EQ(redIn(ball, std::nullopt), 0);
    EXPECT_EQ(redIn(ball, 0), 0);
    EXPECT_GT(redIn(ball, 15), 100);
    IndexedMesh rounded = *ball; // a parting line as files hold it
    for (int v = 0; v < rounded.vertexCount(); ++v)
        if (std::abs(rounded.V(v, 2)) < 1e-9)
            rounded.V(v, 2) = v % 2 ? 1e-6 : -1e-6;
    EXPECT_EQ(redIn(std::make_shared<const IndexedMesh>(rounded), 0), 0);
}

TEST(Job, ComesBackFromItsText) {
    const render::Job job{render::Job::Task::Thumbnail, "a b.moldwright", "out.png", 640, 480};
    const Result<render::Job> back = render::readJob(render::jobText(job));
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(back->task, job.task);
    EXPECT_EQ(back->source, job.source);
    EXPECT_EQ(back->width, 640);
    render::Job german = job;
    german.language = "de";
    EXPECT_EQ(render::readJob(render::jobText(german))->language, "de");
    EXPECT_FALSE(render::readJob("{}").has_value());
    EXPECT_FALSE(render::readJob(R"({"task": "dance", "project": "a", "out": "b"})").has_value());
}

TEST(ReportText, IsInTheLanguageThatIsSpoken) {
    int count = 1;
    char name[] = "render_test";
    char* arguments[] = {name, nullptr};
    const QCoreApplication application(count, arguments);
    EXPECT_EQ(render::ReportText::tr("Open items"), QStringLiteral("Open items"));
    {
        const SpokenLanguage german(QLocale(QStringLiteral("de")));
        EXPECT_EQ(inSpokenLanguage("Chocolate"), "Schokolade") << "notes of materials and of the mold, too";
        EXPECT_NE(inSpokenLanguage("Building the mold was cancelled."), "Building the mold was cancelled.");
        EXPECT_EQ(render::ReportText::tr("Open items"), QStringLiteral("Offene Punkte"));
    }
    const SpokenLanguage none(QLocale::c());
    EXPECT_EQ(render::ReportText::tr("Open items"), QStringLiteral("Open items"));
}

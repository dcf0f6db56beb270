// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/project_file.h"

#include "project/archive.h"
#include "project/binary_parts.h"
#include "project/project_json.h"
#include "project/some_project.h"
#include "project/variant_parts.h"
#include "project/variants.h"
#include "support/folders.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <random>

using namespace moldwright;
using namespace moldwright::test;

namespace {

using Json = nlohmann::ordered_json;

const StoredProject variants = {someVariants(), "", ""};
const StoredProject stored = {someProject(), R"({"camera": 1})", "not really a picture"};

std::string bytesOf(const StoredProject& project) {
    return projectBytes(project).value();
}

std::string message(const Result<StoredProject>& result) {
    return result ? std::string() : result.error().english();
}

/// A project file whose manifest is replaced.
std::string withManifest(const std::string& manifest) {
    return archiveBytes(
               {{"mimetype", "application/vnd.moldwright.project", true}, {"manifest.json", manifest}})
        .value();
}

} // namespace

TEST(ProjectFile, KeepsEverything) {
    const Result<StoredProject> back = readProjectBytes(bytesOf(stored), "box.moldwright");
    ASSERT_TRUE(back.has_value()) << message(back);
    EXPECT_TRUE(equal(back->project, stored.project));
    EXPECT_EQ(back->viewState, stored.viewState);
    EXPECT_EQ(back->thumbnail, stored.thumbnail);
}

TEST(ProjectFile, KeepsAnEmptyProject) {
    const Result<StoredProject> back = readProjectBytes(bytesOf({}), "empty.moldwright");
    ASSERT_TRUE(back.has_value()) << message(back);
    EXPECT_TRUE(equal(back->project, {}));
}

TEST(ProjectFile, EqualProjectsGiveEqualBytes) {
    EXPECT_EQ(bytesOf(stored), bytesOf(stored));
    EXPECT_EQ(bytesOf(readProjectBytes(bytesOf(stored), "a").value()), bytesOf(stored));
    EXPECT_EQ(bytesOf(readProjectBytes(bytesOf(variants), "a").value()), bytesOf(variants));
}

TEST(ProjectFile, KeepsAllVariants) {
    const Result<StoredProject> back = readProjectBytes(bytesOf(variants), "box.moldwright");
    ASSERT_TRUE(back.has_value()) << message(back);
    EXPECT_TRUE(equal(back->project, variants.project));
    EXPECT_EQ(variantNames(back->project), "flat back, B, A");
    // Shared in memory again, and one part in the file.
    EXPECT_EQ(back->project.cast, variantAt(back->project, 0).cast);
    std::vector<ArchiveEntry> parts;
    addVariantParts(parts, back->project);
    EXPECT_EQ(std::ranges::count(parts, "variant-1-cast.mesh", &ArchiveEntry::name), 0);
    EXPECT_EQ(std::ranges::count(parts, "variant-2-cast.mesh", &ArchiveEntry::name), 1);
}

TEST(ProjectFile, OneVariantIsWrittenAsItEverWas) {
    Json document = documentJson(stored.project);
    EXPECT_FALSE(document.contains("variant") || document.contains("variants"));
    Project renamed = withVariantName(stored.project, 0, "tall");
    const Result<StoredProject> back = readProjectBytes(bytesOf({renamed, "", ""}), "x");
    ASSERT_TRUE(back.has_value()) << message(back);
    EXPECT_EQ(back->project.variantName, "tall");
}

TEST(ProjectFile, NamesOfPinsComeBackAndStandBesideTheirPoints) {
    Project project = someProject();
    EXPECT_FALSE(documentJson(project).contains("pin_names")) << "where none has a name";
    project.pins[1].name = "left horn";
    EXPECT_EQ(documentJson(project)["pins"], documentJson(someProject())["pins"]) << "as older programs read";
    const Result<StoredProject> back = readProjectBytes(bytesOf({project, "", ""}), "x");
    ASSERT_TRUE(back.has_value()) << message(back);
    EXPECT_EQ(back->project.pins, project.pins);
}

TEST(ProjectFile, ManifestListsVariantsWhereThereAreSeveral) {
    const ScratchFolder folder;
    ASSERT_TRUE(saveProject(folder.path() / "v.moldwright", variants).has_value());
    const Json manifest = Json::parse(projectManifest(folder.path() / "v.moldwright").value());
    ASSERT_EQ(manifest["variants"].size(), 3U);
    EXPECT_EQ(manifest["variants"][0]["name"], "flat back");
    EXPECT_EQ(manifest["variants"][1]["current"], true);
    EXPECT_EQ(manifest["variants"][2]["cast"]["faces"], manifest["cast"]["faces"]);
    ASSERT_TRUE(saveProject(folder.path() / "s.moldwright", stored).has_value());
    EXPECT_FALSE(Json::parse(projectManifest(folder.path() / "s.moldwright").value()).contains("variants"));
}

TEST(ProjectFile, VariantsThatContradictEachOtherAreRefused) {
    const auto readWith = [](const auto& change) {
        Json document = documentJson(variants.project);
        change(document);
        std::vector<ArchiveEntry> entries = {
            {"mimetype", "application/vnd.moldwright.project", true},
            {"manifest.json",
             R"({"format": "moldwright-project", "version": 1, "minReader": 1, "name": "x", "part": {}})"},
            {"document.json", document.dump()},
            {"part.mesh", meshPart(*variants.project.source)}};
        addVariantParts(entries, variants.project);
        return message(readProjectBytes(archiveBytes(entries).value(), "x"));
    };
    EXPECT_EQ(readWith([](Json&) {}), "");
    EXPECT_EQ(readWith([](Json& document) { document["variant"]["place"] = 99; }), "");
    EXPECT_NE(readWith([](Json& document) { document["variants"][1]["name"] = "B"; }), "");
    EXPECT_NE(readWith([](Json& document) { document["variants"][0]["cast_of"] = 1; }), "");
    EXPECT_NE(readWith([](Json& document) { document["variants"][0].erase("design"); }), "");
    EXPECT_NE(readWith([](Json& document) { document["variants"] = 3; }), "");
}

TEST(ProjectFile, WeightsOfFilesWithoutNamesBecomeARegion) {
    Project project = stored.project;
    project.importance.clear();
    const std::string manifest =
        R"({"format": "moldwright-project", "version": 1, "minReader": 1, "name": "x", "part": {}})";
    std::vector<double> weights(static_cast<std::size_t>(project.part->faceCount()), 1);
    weights[2] = 4;
    weights[5] = 1.5;
    const auto bytesWith = [&](const std::vector<double>& numbers) {
        Project bare = project;
        bare.cast = nullptr;
        return archiveBytes({{"mimetype", "application/vnd.moldwright.project", true},
                             {"manifest.json", manifest},
                             {"document.json", documentJson(bare).dump()},
                             {"part.mesh", meshPart(*project.source)},
                             {"weights.numbers", numbersPart(numbers)}})
            .value();
    };
    const Result<StoredProject> back = readProjectBytes(bytesWith(weights), "old.moldwright");
    ASSERT_TRUE(back.has_value()) << message(back);
    EXPECT_EQ(back->project.importance, (std::vector<ImportantRegion>{{"1", {2, 5}, {4, 1.5}, 0}}));
    weights.pop_back();
    EXPECT_NE(message(readProjectBytes(bytesWith(weights), "old.moldwright")).find("weights.numbers"),
              std::string::npos);
}

TEST(ProjectFile, BeginsWithItsTypeAsPlainBytes) {
    const std::string bytes = bytesOf(stored);
    EXPECT_EQ(bytes.substr(0, 2), "PK");
    EXPECT_EQ(bytes.substr(30, 8), "mimetype");
    EXPECT_EQ(bytes.substr(38, 34), "application/vnd.moldwright.project");
}

TEST(ProjectFile, SavesAndOpens) {
    const ScratchFolder folder;
    const auto file = folder.path() / "box.moldwright";
    ASSERT_TRUE(saveProject(file, stored).has_value());
    const Result<StoredProject> back = openProject(file);
    ASSERT_TRUE(back.has_value()) << message(back);
    EXPECT_TRUE(equal(back->project, stored.project));
    const Result<std::string> manifest = projectManifest(file);
    ASSERT_TRUE(manifest.has_value());
    EXPECT_NE(manifest->find("\"minReader\": 1"), std::string::npos);
}

TEST(ProjectFile, MissingFilesAndOtherFilesAreNamed) {
    const ScratchFolder folder;
    EXPECT_NE(message(openProject(folder.path() / "none.moldwright")).find("none.moldwright"),
              std::string::npos);
    std::ofstream(folder.path() / "text.moldwright") << "solid cube";
    EXPECT_NE(message(openProject(folder.path() / "text.moldwright")).find("not a Moldwright project"),
              std::string::npos);
    const std::string other = archiveBytes({{"mimetype", "application/epub+zip", true}}).value();
    EXPECT_NE(message(readProjectBytes(other, "book")).find("not a Moldwright project"), std::string::npos);
}

TEST(ProjectFile, NewerFilesSayWhichReaderTheyNeed) {
    const std::string bytes =
        withManifest(R"({"format": "moldwright-project", "version": 9, "minReader": 7, "name": ""})");
    const Result<StoredProject> back = readProjectBytes(bytes, "new.moldwright");
    ASSERT_FALSE(back.has_value());
    EXPECT_EQ(back.error().code, ErrorCode::BadInput);
    EXPECT_EQ(message(back),
              "new.moldwright was saved by a newer Moldwright. A program that reads format 7 is "
              "needed; this one reads up to 1.");
}

TEST(ProjectFile, MissingPartsAreNamed) {
    const std::string bytes =
        withManifest(R"({"format": "moldwright-project", "version": 1, "minReader": 1, "name": ""})");
    EXPECT_NE(message(readProjectBytes(bytes, "a.moldwright")).find("document.json"), std::string::npos);
    const std::string odd = withManifest(R"({"format": 3, "minReader": "one"})");
    EXPECT_NE(message(readProjectBytes(odd, "a.moldwright")).find("manifest.json"), std::string::npos);
    EXPECT_NE(message(readProjectBytes(withManifest("[1]"), "a.moldwright")).find("manifest.json"),
              std::string::npos);
}

TEST(ProjectFile, APartThatInflatesBeyondItsLimitIsRefused) {
    const std::string bomb = R"({"format": "moldwright-project", "version": 1, "minReader": 1})" +
                             std::string(std::size_t{5} << 20, ' ');
    const std::string bytes = withManifest(bomb);
    EXPECT_LT(bytes.size(), 20000U);
    EXPECT_NE(message(readProjectBytes(bytes, "bomb")).find("manifest.json"), std::string::npos);
}

TEST(ProjectFile, FlippedBitsNeverCrashNorPassUnseen) {
    for (const StoredProject& saved : {stored, variants, StoredProject{someTrays(), "", ""}}) {
        const std::string whole = bytesOf(saved);
        std::mt19937 random(1);
        for (int i = 0; i < 1000; ++i) {
            std::string bytes = whole;
            bytes[random() % bytes.size()] ^= static_cast<char>(1U << random() % 8);
            const Result<StoredProject> back = readProjectBytes(bytes, "flipped");
            if (back)
                EXPECT_TRUE(equal(back->project, saved.project)) << i;
            else
                EXPECT_EQ(back.error().code, ErrorCode::BadInput);
        }
    }
}

TEST(ProjectFile, TruncatedFilesAreRefused) {
    const std::string whole = bytesOf(stored);
    for (std::size_t i = 0; i < 200; ++i)
        EXPECT_FALSE(readProjectBytes(whole.substr(0, i * whole.size() / 200), "short").has_value()) << i;
}

// SPDX-License-Identifier: AGPL-3.0-or-later
// Further parts of molds in a project file.
#include "project/further_parts_json.h"

#include "project/archive.h"
#include "project/binary_parts.h"
#include "project/project_file.h"
#include "project/project_json.h"
#include "project/some_project.h"
#include "project/variant_parts.h"
#include "project/variants.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>

using namespace moldwright;
using namespace moldwright::test;

namespace {

using Json = nlohmann::ordered_json;

std::string message(const Result<StoredProject>& result) {
    return result ? std::string() : result.error().english();
}

/// What reading says of a project file whose document and parts were changed.
std::string readWith(const std::function<void(Json&)>& change,
                     const std::function<void(std::vector<ArchiveEntry>&)>& damage = {}) {
    const Project project = someTrays();
    Json document = documentJson(project);
    change(document);
    std::vector<ArchiveEntry> entries = {
        {"mimetype", "application/vnd.moldwright.project", true},
        {"manifest.json",
         R"({"format": "moldwright-project", "version": 1, "minReader": 1, "name": "x", "part": {}})"},
        {"document.json", document.dump()},
        {"part.mesh", meshPart(*project.source)}};
    addVariantParts(entries, project);
    if (damage)
        damage(entries);
    return message(readProjectBytes(archiveBytes(entries).value(), "tray.moldwright"));
}

} // namespace

TEST(FurtherPartsJson, ComeBackWithMeshesLabelsAndStates) {
    const Project project = someTrays();
    const Result<StoredProject> back = readProjectBytes(projectBytes({project, "", ""}).value(), "x");
    ASSERT_TRUE(back.has_value()) << message(back);
    EXPECT_TRUE(equal(back->project, project));
    ASSERT_EQ(back->project.furtherParts.size(), 2U);
    EXPECT_EQ(projectBytes(*back).value(), projectBytes({project, "", ""}).value());
    const Json manifest =
        Json::parse(ArchiveReader::open(projectBytes(*back).value())->read("manifest.json", 1 << 20).value());
    EXPECT_EQ(manifest["further_parts"],
              Json::parse(R"([{"name": "ring", "count": 1}, {"name": "ball ∅", "count": 3}])"));
}

TEST(FurtherPartsJson, ACastThatSeveralHaveIsThereOnce) {
    const Project project = someTrays();
    EXPECT_EQ(furtherCasts(project).size(), 2U);
    std::vector<ArchiveEntry> entries;
    addVariantParts(entries, project);
    EXPECT_EQ(std::ranges::count_if(
                  entries, [](const ArchiveEntry& entry) { return entry.name.starts_with("further-cast-"); }),
              4)
        << "mesh and labels of each";
    const Project back = readProjectBytes(projectBytes({project, "", ""}).value(), "x")->project;
    EXPECT_EQ(back.furtherParts[1].cast, variantAt(back, 0).furtherParts[0].cast) << "in memory too";
}

TEST(FurtherPartsJson, FilesWithoutThemHaveNone) {
    const Json document = documentJson(someVariants());
    EXPECT_FALSE(document.contains("further_parts") || document.contains("further_casts"));
    EXPECT_EQ(readWith([](Json& old) {
                  old.erase("further_parts");
                  old.erase("further_casts");
                  for (Json& variant : old["variants"])
                      variant.erase("further_parts");
              }),
              "");
}

TEST(FurtherPartsJson, WhatContradictsItselfIsRefusedByItsFile) {
    EXPECT_EQ(readWith([](Json&) {}), "");
    const auto expectRefused = [](const std::function<void(Json&)>& change) {
        const std::string said = readWith(change);
        EXPECT_NE(said.find("tray.moldwright"), std::string::npos) << said;
        EXPECT_NE(said.find("document.json"), std::string::npos) << said;
    };
    expectRefused([](Json& document) { document["further_parts"][0]["cast"] = 2; });
    expectRefused([](Json& document) { document["further_parts"][0]["cast"] = -1; });
    expectRefused([](Json& document) { document["further_parts"][0]["count"] = 0; });
    expectRefused([](Json& document) { document["further_parts"][0]["count"] = 401; });
    expectRefused([](Json& document) { document["further_parts"][0].erase("name"); });
    expectRefused([](Json& document) { document["further_casts"][1].erase("state"); });
    expectRefused([](Json& document) { document.erase("further_casts"); });
    expectRefused([](Json& document) { document["further_parts"] = 3; });
    expectRefused([](Json& document) { // meshes would be taken for one another's
        std::swap(document["further_parts"][0]["cast"], document["further_parts"][1]["cast"]);
    });
}

TEST(FurtherPartsJson, DamagedMeshesAndLabelsAreNamed) {
    const auto said = [](const std::string& name, const std::string& bytes) {
        return readWith([](Json&) {},
                        [&](std::vector<ArchiveEntry>& entries) {
                            std::ranges::find(entries, name, &ArchiveEntry::name)->bytes = bytes;
                        });
    };
    for (const std::string name : {"further-cast-1.mesh", "further-cast-2.labels"})
        EXPECT_NE(said(name, "short").find(name), std::string::npos) << said(name, "short");
    EXPECT_NE(said("further-cast-1.labels", labelsPart({1, 2})).find("further-cast-1.labels"),
              std::string::npos)
        << "not one for each face";
    EXPECT_NE(said("further-cast-1.mesh", meshPart({})), "");
}

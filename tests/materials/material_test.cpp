// SPDX-License-Identifier: AGPL-3.0-or-later
#include "materials/material.h"

#include "support/folders.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

using namespace moldwright;

namespace {

std::vector<Material> bundled() {
    std::ifstream in(test::sourceFolder() / "resources/materials/materials.json");
    std::ostringstream text;
    text << in.rdbuf();
    return materialsFrom(text.str(), "materials.json").value();
}

} // namespace

TEST(Materials, BundledOnesAllSayWhereTheirNumbersComeFrom) {
    const std::vector<Material> table = bundled();
    EXPECT_GE(table.size(), 20U);
    for (const Material& m : table)
        for (const MaterialValue& value : {m.shrinkPercent, m.draftDegrees, m.density}) {
            EXPECT_FALSE(value.source.empty()) << m.id;
            EXPECT_FALSE(value.status.empty()) << m.id;
        }
}

TEST(Materials, AreFoundByIdAndName) {
    const std::vector<Material> table = bundled();
    EXPECT_EQ(materialNamed(table, "ABS")->shrinkPercent.value, 0.5);
    EXPECT_EQ(materialNamed(table, "polypropylene")->id, "pp");
    EXPECT_LT(materialNamed(table, "plaster")->shrinkPercent.value, 0);
    const Result<Material> unknown = materialNamed(table, "unobtainium");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::Usage);
    EXPECT_NE(unknown.error().english().find("pa66"), std::string::npos);
}

TEST(Materials, OwnOnesReplaceAndFollow) {
    const std::string json = R"({"materials": [
        {"id": "abs", "name": "Our ABS", "shrink_percent": {"value": 0.62, "source": "coupon"},
         "formula": "divide", "draft_deg": {"value": 2, "source": "us"}, "density_g_cm3": {"value": 1.04, "source": "us"}},
        {"id": "soap", "name": "Soap", "shrink_percent": {"value": 1, "source": "coupon"},
         "draft_deg": {"value": 4, "source": "us"}, "density_g_cm3": {"value": 1.1, "source": "us"}}]})";
    const std::vector<Material> base = bundled();
    const std::vector<Material> table = withOwn(base, materialsFrom(json, "own.json").value());
    EXPECT_EQ(table.size(), base.size() + 1);
    EXPECT_EQ(table.front().name, "Our ABS");
    EXPECT_TRUE(table.front().divide);
    EXPECT_EQ(table.back().id, "soap");
}

TEST(Materials, NonsenseIsRefusedByName) {
    for (const char* json :
         {"{", R"({"materials": [{"id": "x"}]})",
          R"({"materials": [{"id": "x", "name": "X", "shrink_percent": {"value": 70, "source": "s"},
              "draft_deg": {"value": 1, "source": "s"}, "density_g_cm3": {"value": 1, "source": "s"}}]})"}) {
        const Result<std::vector<Material>> table = materialsFrom(json, "own.json");
        ASSERT_FALSE(table);
        EXPECT_EQ(table.error().code, ErrorCode::BadInput);
        EXPECT_NE(table.error().english().find("own.json"), std::string::npos);
    }
}

TEST(Materials, AreWrittenAsTheyAreRead) {
    for (const Material& m : bundled())
        EXPECT_EQ(materialFromJson(materialJson(m)), m) << m.id;
}

TEST(Materials, TablesOfOldHaveOneTextForThePreparation) {
    const std::string json = R"({"materials": [{"id": "soap", "name": "Soap",
        "shrink_percent": {"value": 1, "source": "coupon"}, "draft_deg": {"value": 4, "source": "us"},
        "density_g_cm3": {"value": 1.1, "source": "us"}, "preparation": "Grease it."}]})";
    EXPECT_EQ(materialsFrom(json, "own.json")->front().preparation,
              (Preparation{{}, {}, "Grease it.", {}, {}}));
}

TEST(Materials, PaperRecipesAreThere) {
    const std::vector<Material> table = bundled();
    const Preparation foam = materialNamed(table, "pu-foam")->preparation;
    EXPECT_FALSE(foam.sealing.empty());
    EXPECT_FALSE(foam.release.empty());
    const Preparation gummy = materialNamed(table, "gummy")->preparation;
    EXPECT_FALSE(gummy.release.empty());
    EXPECT_NE(gummy.setting.find("4 °C"), std::string::npos) << "40 °F";
}

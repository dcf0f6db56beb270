// SPDX-License-Identifier: AGPL-3.0-or-later
#include "materials/material_table.h"

#include "support/folders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

using namespace moldwright;

namespace {

/// The bundled table, and a folder of the user's own that is not there yet.
class MaterialTable : public testing::Test {
protected:
    [[nodiscard]] Material bundled(const std::string& id) const {
        return materialNamed(*materialTable({m_places.bundled, std::nullopt}), id).value();
    }
    [[nodiscard]] Material named(const std::string& id) const {
        return materialNamed(*materialTable(m_places), id).value();
    }
    void write(const std::string& file, const std::string& text) const {
        std::filesystem::create_directories(*m_places.own);
        std::ofstream(*m_places.own / file) << text;
    }

    test::ScratchFolder m_folder;
    MaterialPlaces m_places{test::sourceFolder() / "resources/materials/materials.json",
                            m_folder.path() / "not/yet/there"};
};

constexpr const char* kTwo = R"({"note": "ours", "materials": [
    {"id": "soap", "name": "Soap", "by": "Ann", "shrink_percent": {"value": 1, "source": "coupon"},
     "draft_deg": {"value": 4, "source": "us"}, "density_g_cm3": {"value": 1.1, "source": "us"}},
    {"id": "ice", "name": "Ice", "shrink_percent": {"value": -3, "source": "tables"},
     "draft_deg": {"value": 3, "source": "us"}, "density_g_cm3": {"value": 0.92, "source": "tables"}}]})";

} // namespace

TEST_F(MaterialTable, AChangedMaterialTakesTheBundledOnesPlaceUntilItIsRemoved) {
    Material abs = bundled("abs");
    abs.shrinkPercent = {0.62, "", "coupon of 2026"};
    abs.preparation.release = "Wax";
    ASSERT_TRUE(saveMaterial(m_places, abs));
    EXPECT_EQ(named("abs"), abs);
    EXPECT_EQ(materialTable(m_places)->size(), materialTable({m_places.bundled, {}})->size());
    EXPECT_EQ(*ownMaterials(m_places), std::vector{abs});
    ASSERT_TRUE(removeMaterial(m_places, "abs"));
    EXPECT_EQ(named("abs"), bundled("abs"));
    EXPECT_TRUE(std::filesystem::is_empty(*m_places.own));
    EXPECT_EQ(removeMaterial(m_places, "abs").error().code, ErrorCode::Usage);
}

TEST_F(MaterialTable, OfTheUserKeepsWhatElseStandsInIt) {
    write("ours.json", kTwo);
    Material soap = named("soap");
    soap.density.value = 1.2;
    ASSERT_TRUE(saveMaterial(m_places, soap));
    EXPECT_EQ(named("soap").density.value, 1.2);
    EXPECT_EQ(named("ice").density.value, 0.92);
    ASSERT_TRUE(removeMaterial(m_places, "soap"));
    EXPECT_EQ(ownMaterials(m_places)->size(), 1U);
    std::ifstream in(*m_places.own / "ours.json");
    std::ostringstream text;
    text << in.rdbuf();
    EXPECT_NE(text.str().find("\"note\": \"ours\""), std::string::npos);
}

TEST_F(MaterialTable, OfSeveralTablesTheLastHoldsAndIsChanged) {
    write("a.json", kTwo);
    write("b.json", kTwo);
    Material ice = named("ice");
    ice.shrinkPercent.value = -8;
    ASSERT_TRUE(saveMaterial(m_places, ice));
    EXPECT_EQ(named("ice").shrinkPercent.value, -8);
    ASSERT_TRUE(removeMaterial(m_places, "ice")) << "from both";
    EXPECT_EQ(ownMaterials(m_places)->size(), 1U);
}

TEST_F(MaterialTable, RefusesWhatCannotBe) {
    Material odd = bundled("abs");
    odd.density.value = 0;
    EXPECT_EQ(saveMaterial(m_places, odd).error().code, ErrorCode::Usage);
    odd = bundled("abs");
    for (const char* id : {"../abs", "", "A", "a b"}) {
        odd.id = id;
        EXPECT_FALSE(saveMaterial(m_places, odd)) << id;
    }
    EXPECT_FALSE(std::filesystem::exists(*m_places.own));
}

TEST_F(MaterialTable, ThatCannotBeReadIsNamedAndLeftAlone) {
    write("broken.json", "{");
    const auto table = materialTable(m_places);
    ASSERT_FALSE(table);
    EXPECT_NE(table.error().english().find("broken.json"), std::string::npos);
    EXPECT_FALSE(saveMaterial(m_places, bundled("abs")));
    EXPECT_EQ(std::filesystem::file_size(*m_places.own / "broken.json"), 1U);
}

TEST_F(MaterialTable, NewIdsAreFree) {
    const std::vector<Material> table = *materialTable(m_places);
    EXPECT_EQ(freeMaterialId("Our soap, №2", table), "our-soap-2");
    EXPECT_EQ(freeMaterialId("ABS", table), "abs-2");
    EXPECT_EQ(freeMaterialId("石膏", table), "material");
}

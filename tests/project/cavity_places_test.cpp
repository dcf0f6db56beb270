// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/cavity_places.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace moldwright;

TEST(CavityPlaces, AreReadAsAPersonWritesThem) {
    const auto places = cavityPlacesOf("0,0; 40.5, -5 ,90\n-1e1 2;");
    ASSERT_TRUE(places) << places.error().english();
    EXPECT_EQ(*places, (std::vector<CavityPlace>{{0, 0, 0}, {40.5, -5, 90}, {-10, 2, 0}}));
    EXPECT_EQ(cavityPlacesText(*places), "0, 0; 40.5, -5, 90; -10, 2");
    EXPECT_EQ(*cavityPlacesOf(cavityPlacesText(*places)), *places);
    EXPECT_TRUE(cavityPlacesOf(" ")->empty());
}

TEST(CavityPlaces, TellWhichOneCannotBeRead) {
    for (const char* wrong : {"1, 2; 3", "1, 2; 3, x", "1, 2; 3, 4, 5, 6", "1, 2; 3, inf"}) {
        const auto places = cavityPlacesOf(wrong);
        ASSERT_FALSE(places) << wrong;
        EXPECT_EQ(places.error().code, ErrorCode::BadInput);
        EXPECT_NE(places.error().english().find('3'), std::string::npos) << places.error().english();
    }
}

TEST(CavityPlaces, OfAListNeedTwoNumbers) {
    const auto read = [](const char* text) { return cavityPlacesFrom(nlohmann::ordered_json::parse(text)); };
    EXPECT_EQ(*read(R"([{"at": [1, 2]}, {"at": [3, 4], "turn_deg": 5}])"),
              (std::vector<CavityPlace>{{1, 2, 0}, {3, 4, 5}}));
    for (const char* wrong :
         {R"([{"at": [1]}])", R"([{}])", R"([[1, 2]])", R"([{"at": [1, 2], "turn_deg": "x"}])"})
        EXPECT_FALSE(read(wrong)) << wrong;
}

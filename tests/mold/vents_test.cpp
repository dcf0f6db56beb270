// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/mold.h"

#include "features/drafted_prism.h"
#include "support/casts.h"
#include "support/molds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector3d;

namespace {

constexpr double lean = 0.09;

/// Towers on a bar, of the outline that is given.
IndexedMesh twoTowers(PlanShape outline) {
    PrismRequest towers;
    towers.base = std::move(outline);
    towers.height = {3, 3};
    towers.directions = {std::vector<Vector3d>{Vector3d::UnitZ()}, std::vector<Vector3d>{-Vector3d::UnitZ()}};
    towers.grid = 1.0 / 65536;
    return *prismSolid(draftedPrism(towers).value());
}

} // namespace

TEST(Vents, ServeWhatTheSpoutDoesNot) {
    // The lower one traps air when both point up.
    const IndexedMesh part =
        twoTowers({{0, 0}, {30, 0}, {30, 20}, {22, 20}, {22, 8}, {8, 8}, {8, 17}, {0, 17}});
    MoldSettings settings = everyFeature();
    std::vector<int> vents;
    for (const PourDirection pour :
         {PourDirection::Turn0, PourDirection::Turn90, PourDirection::Turn180, PourDirection::Turn270}) {
        settings.spout.pour = pour;
        const Result<Mold> mold = moldOf({part, {}}, settings);
        expectVerified(mold);
        vents.push_back(count(*mold, "vent"));
        EXPECT_EQ(mold->trappedAir, 0);
    }
    EXPECT_EQ(*std::max_element(vents.begin(), vents.end()), 1);
    settings.vents.depth = 0.25;
    for (const PourDirection pour : {PourDirection::Turn0, PourDirection::Turn180, PourDirection::Turn270}) {
        settings.spout.pour = pour;
        const Result<Mold> mold = moldOf({part, {}}, settings);
        expectVerified(mold);
        for (const MoldFeature& feature : mold->features)
            if (feature.kind == "vent") {
                EXPECT_NEAR(feature.numbers[1].second + feature.numbers[2].second, 0.25, 1e-4);
            }
    }
    settings.spout.pour = PourDirection::Automatic;
    EXPECT_EQ(count(*moldOf({part, {}}, settings), "vent"), 0) << "upside down nothing is trapped";
}

TEST(Vents, NeedASpout) {
    MoldSettings settings;
    settings.vents.on = true;
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), settings);
    ASSERT_FALSE(mold);
    EXPECT_EQ(mold.error().code, ErrorCode::Usage);
}

TEST(Vents, InThePlaneAreKeptClearOfByKeys) {
    // Between the low tower and the runner there is room for a key, and that is where its vent runs.
    const IndexedMesh part =
        twoTowers({{0, 0}, {60, 0}, {60, 50}, {50, 50}, {50, 8}, {6, 8}, {6, 14}, {2, 14}, {0, 12}});
    MoldSettings settings = everyFeature();
    settings.keys.diameter = 8; // too wide for the corners
    int vents = 0;
    for (const PourDirection pour :
         {PourDirection::Turn0, PourDirection::Turn90, PourDirection::Turn180, PourDirection::Turn270})
        for (const int columns : {1, 2, 3})
            for (const int keys : {1, 2, 4}) {
                settings.spout.pour = pour;
                settings.layout.columns = columns;
                settings.keys.count = keys;
                const Result<Mold> mold = moldOf({part, {}}, settings);
                expectVerified(mold);
                ASSERT_TRUE(mold);
                vents += count(*mold, "vent");
                EXPECT_EQ(count(*mold, "key"), keys);
            }
    EXPECT_GE(vents, 3 * (1 + 2 + 3)) << "one of the turns leaves air in the low tower";
}

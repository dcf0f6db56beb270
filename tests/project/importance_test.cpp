// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/importance.h"

#include "project/edits.h"
#include "project/some_project.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

const ImportantRegion eye{"eye", {2, 5, 9}, {2, 4, 3}, 0.2};

} // namespace

TEST(Importance, AStrokeDoublesWhatItCoversAndTakesNewFacesIn) {
    const ImportantRegion painted = heavier(eye, {1, 5, 12});
    EXPECT_EQ(painted.faces, std::vector({1, 2, 5, 9, 12}));
    EXPECT_EQ(painted.weights, std::vector<double>({2, 2, 8, 3, 2}));
    EXPECT_EQ(painted.name, "eye");
    EXPECT_EQ(painted.keepWithin, 0.2);
    EXPECT_EQ(heavier(eye, {}), eye);
}

TEST(Importance, AStrokeThatErasesHalvesAndLetsGoOfWhatWeighsNoMore) {
    const ImportantRegion erased = lighter(eye, {2, 5, 7});
    EXPECT_EQ(erased.faces, std::vector({5, 9}));
    EXPECT_EQ(erased.weights, std::vector<double>({2, 3}));
    EXPECT_EQ(lighter(heavier(eye, {7}), {7}), eye);
}

TEST(Importance, WeightsEndAtTheMost) {
    ImportantRegion region = eye;
    for (int stroke = 0; stroke < 20; ++stroke)
        region = heavier(region, {5});
    EXPECT_EQ(heaviest(region), mostWeight);
    EXPECT_EQ(weighing(eye, 1e9).weights, std::vector(3, mostWeight));
    EXPECT_EQ(weighing(eye, 0).weights, std::vector(3, 1.0));
    EXPECT_EQ(heaviest({}), 1);
}

TEST(Importance, WhereRegionsOverlapTheLargerWeightHolds) {
    const ImportantRegion logo{"logo", {0, 5}, {3, 2}, 0};
    EXPECT_EQ(faceWeights({eye, logo}, 7 + 3), std::vector<double>({3, 1, 2, 1, 1, 4, 1, 1, 1, 3}));
    EXPECT_TRUE(faceWeights({weighing(eye, 1)}, 10).empty()) << "only measured";
}

TEST(Importance, IsMeasuredAgainstItsLimit) {
    EXPECT_TRUE(keepsWithin(eye, {"eye", 0.2}));
    EXPECT_FALSE(keepsWithin(eye, {"eye", 0.21}));
    EXPECT_TRUE(keepsWithin({"free", {0}, {2}, 0}, {"free", 50}));
    ASSERT_EQ(keptRegions({eye}).size(), 1U);
    EXPECT_EQ(keptRegions({eye})[0].within, 0.2);
    EXPECT_EQ(keptRegions({eye})[0].faces, eye.faces);
}

TEST(Importance, ACastOutlivesNamesAndLimitsButNotWeights) {
    const Project project = test::someProject();
    std::vector<ImportantRegion> regions = project.importance;
    regions[0].name = "left eye";
    regions[0].keepWithin = 3;
    EXPECT_EQ(withImportance(project, regions).cast, project.cast);
    EXPECT_EQ(withImportance(project, regions).importance[0].name, "left eye");
    regions[0] = heavier(regions[0], {3});
    EXPECT_FALSE(withImportance(project, regions).cast);
    EXPECT_FALSE(withImportance(project, {}).cast);
}

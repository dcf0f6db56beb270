// SPDX-License-Identifier: AGPL-3.0-or-later
// What is said of a mold while a feature is dragged is what the mold has when it is built.
#include "mold/mold_sketch.h"

#include "support/casts.h"
#include "support/molds.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector2d;

namespace {

Result<MoldSketcher> sketcherOf(const KnownCast& cast, const MoldSettings& settings) {
    return MoldSketcher::prepared(trayOf(cast), 1, settings);
}

void expectSameFeatures(const std::vector<MoldFeature>& sketched, const std::vector<MoldFeature>& built) {
    ASSERT_EQ(sketched.size(), built.size());
    for (std::size_t i = 0; i < built.size(); ++i) {
        EXPECT_EQ(sketched[i].name, built[i].name);
        EXPECT_EQ(sketched[i].place, built[i].place) << built[i].name;
        EXPECT_EQ(sketched[i].numbers, built[i].numbers) << built[i].name;
        EXPECT_EQ(sketched[i].stands, built[i].stands) << built[i].name;
        EXPECT_EQ(sketched[i].byHand, built[i].byHand) << built[i].name;
        EXPECT_EQ(sketched[i].outline, built[i].outline) << built[i].name;
    }
}

/// The sketcher's answer for these places, and the mold built with them.
void expectAsBuilt(MoldSketcher& sketcher, const KnownCast& cast, MoldSettings settings,
                   const PlacedFeatures& placed) {
    settings.placed = placed;
    const Result<Mold> mold = moldOf(cast, settings);
    ASSERT_TRUE(sketcher.serves(settings));
    const Result<MoldSketch> sketch = sketcher.sketch(placed);
    const bool collides = sketch && sketch->steel.front().thickness <= 0;
    ASSERT_EQ(sketch && !collides, mold.has_value()) << (sketch ? "" : sketch.error().english());
    if (!sketch) {
        EXPECT_EQ(sketch.error().english(), mold.error().english());
        return;
    }
    if (collides)
        return; // it is marked, and the build refuses it
    EXPECT_EQ(sketch->settings, mold->settings);
    EXPECT_EQ(sketch->steel, mold->steelOfEach);
    EXPECT_EQ(sketch->block.box().sizes().x(), mold->half1.size.x());
    EXPECT_EQ(sketch->block.box().sizes().y(), mold->half1.size.y());
    EXPECT_EQ(sketch->trappedAir, mold->trappedAir);
    EXPECT_EQ(sketch->partToMold.matrix(), mold->partToMold.matrix());
    expectSameFeatures(sketch->features, mold->features);
}

MoldSettings withEverything() {
    MoldSettings settings = everyFeature();
    settings.bolts.count = 2;
    settings.ejectors.count = 1;
    settings.ejectors.diameter = 2.5;
    return settings;
}

} // namespace

TEST(MoldSketch, IsTheMoldThatIsBuilt) {
    const KnownCast cast = moved(sheared(ball(18, 4), 0.3, -0.2), {1, 2, 3}, 0.8, {5, -7, 2});
    for (const int columns : {1, 2}) {
        MoldSettings settings = withEverything();
        settings.layout.columns = columns;
        Result<MoldSketcher> sketcher = sketcherOf(cast, settings);
        ASSERT_TRUE(sketcher);
        expectAsBuilt(*sketcher, cast, settings, {});
        expectAsBuilt(*sketcher, cast, settings, {{Placeable::Key, 1, {3, 34}}});
        expectAsBuilt(
            *sketcher, cast, settings,
            {{Placeable::Key, 1, {40, 3}}, {Placeable::Slit, 0, {1, -9}}, {Placeable::Bolt, 1, {-50, 2}}});
        expectAsBuilt(*sketcher, cast, settings, {{Placeable::Spout, 0, {columns == 1 ? 2.0 : 1.0, 0}}});
        expectAsBuilt(*sketcher, cast, settings, {{Placeable::Ejector, 0, {2, -3}}});
        expectAsBuilt(*sketcher, cast, settings, {{Placeable::Ejector, 0, {200, 0}}});
        expectAsBuilt(*sketcher, cast, settings, {{Placeable::Spout, 0, {60, 0}}});
        expectAsBuilt(*sketcher, cast, settings, {});
    }
}

TEST(MoldSketch, IsTheMoldThatIsBuiltLyingFlat) {
    MoldSettings settings = withEverything();
    settings.spout.resting = Resting::Lying;
    const KnownCast cast = ring(24, 10, 96, 32);
    Result<MoldSketcher> sketcher = sketcherOf(cast, settings);
    ASSERT_TRUE(sketcher);
    expectAsBuilt(*sketcher, cast, settings, {});
    expectAsBuilt(*sketcher, cast, settings, {{Placeable::Spout, 0, {0, 24}}});
}

TEST(MoldSketch, MarksWhatTheBuildRefuses) {
    MoldSettings settings = withEverything();
    const KnownCast cast = ball(18, 4);
    Result<MoldSketcher> sketcher = sketcherOf(cast, settings);
    const PlacedFeatures placed = {{Placeable::Key, 1, {4, 4}}};
    const Result<MoldSketch> sketch = sketcher->sketch(placed);
    ASSERT_TRUE(sketch);
    const ThinSteel* thin = thinnestAbout(sketch->steel, Placeable::Key, 1);
    ASSERT_NE(thin, nullptr);
    EXPECT_EQ(thin->thickness, 0);
    settings.placed = placed;
    EXPECT_FALSE(moldOf(cast, settings));
}

TEST(MoldSketch, ServesOnlyItsOwnSettings) {
    MoldSettings settings = withEverything();
    const Result<MoldSketcher> sketcher = sketcherOf(ball(18, 3), settings);
    ASSERT_TRUE(sketcher);
    settings.placed = {{Placeable::Key, 1, {4, 4}}};
    EXPECT_TRUE(sketcher->serves(settings));
    settings.keys.diameter += 1;
    EXPECT_FALSE(sketcher->serves(settings));
}

// SPDX-License-Identifier: AGPL-3.0-or-later
// Runners in a grid over which all cavities fill together.
#include "mold/balanced_runners.h"

#include "mesh/check.h"
#include "mesh/measures.h"
#include "mold/mold_sketch.h"
#include "support/casts.h"
#include "support/molds.h"
#include "support/plan_area.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector2d;

namespace {

const double lean = std::tan(radians(5));

MoldSettings balancedGrid(int rows, int columns) {
    MoldSettings settings = everyFeature();
    settings.layout.rows = rows;
    settings.layout.columns = columns;
    settings.spout.runners = Runners::Balanced;
    return settings;
}

void expectWaysOfOneLength(const Mold& mold) {
    ASSERT_EQ(static_cast<int>(mold.pathLengths.size()), mold.cavities);
    const auto [least, most] = std::minmax_element(mold.pathLengths.begin(), mold.pathLengths.end());
    EXPECT_NEAR(*least, *most, 1e-9);
    EXPECT_GT(*least, mold.settings.layout.spacing);
}

ChannelBranch gateAt(double x, double y, double reach, std::size_t copy) {
    return {{x, y}, reach, {}, copy};
}

} // namespace

TEST(ChannelTree, JoinsPairsWhereBothWaysAreAsLong) {
    // The second gate's stub is 4 mm longer: the joint stands 2 mm nearer to it.
    const auto tree = joinedInPairs({gateAt(0, 0, 3, 0), gateAt(20, 0, 7, 1)}, Across::X, {10}, 1);
    ASSERT_TRUE(tree);
    EXPECT_EQ(tree->at, Vector2d(12, 10));
    EXPECT_DOUBLE_EQ(tree->reach, 3 + 10 + 12);
    const TreeOutline outline = outlineOf(*tree, {2, 3, 1}, 2);
    EXPECT_DOUBLE_EQ(outline.lengths[0], 25);
    EXPECT_DOUBLE_EQ(outline.lengths[1], 25);
    EXPECT_FALSE(joinedInPairs({gateAt(0, 0, 0, 0), gateAt(20, 0, 21, 1)}, Across::X, {10}, 1))
        << "further than the other gate";
}

TEST(ChannelTree, OutlineIsThatOfItsStrips) {
    // Two gates aside of a column, as a grid of two rows has them.
    const auto tree = joinedInPairs({gateAt(0, 0, 5, 0), gateAt(0, 30, 5, 1)}, Across::Y, {12}, 1);
    ASSERT_TRUE(tree);
    const ChannelBranch root = ledTo(*tree, Across::X, 22);
    const TreeWidths widths{4, 6, 3};
    TreeOutline outline = outlineOf(root, widths, 2);
    outline.shape.emplace_back(25, 17); // below the spout, which is missing
    // Arms 3 + 12 + 2 mm long, 30 − 4 mm between them, from there 10 − 2 − 3 to the spout's left side and on
    // to its right one.
    EXPECT_NEAR(test::planArea(outline.shape), 2 * 17 * 4 + 26 * 4 + 5 * 4 + 6 * 4, 1e-9);
    for (const std::size_t gate : {0UL, 1UL}) {
        const Vector2d& from = outline.shape[outline.edges[gate]];
        const Vector2d& to = outline.shape[outline.edges[gate] + 1];
        EXPECT_EQ(from, Vector2d(-3, 30.0 * static_cast<double>(gate) - 2)) << "looks down at the gate";
        EXPECT_EQ(to.y(), from.y());
        EXPECT_GT(to.x(), from.x());
    }
    for (const PlanShape& strip : stripsOf(root, widths))
        for (const Vector2d& p : strip)
            EXPECT_LE(planDistanceTo(outline.shape, p), 1e-9);
}

TEST(BalancedRunners, FillAllCavitiesOverWaysOfOneLength) {
    for (const auto& [rows, columns] : {std::pair{1, 4}, {2, 2}, {4, 1}, {2, 1}, {4, 4}, {2, 8}}) {
        SCOPED_TRACE(std::to_string(rows) + " x " + std::to_string(columns));
        const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), balancedGrid(rows, columns));
        expectVerified(mold);
        EXPECT_EQ(mold->cavities, rows * columns);
        EXPECT_EQ(count(*mold, "gate"), rows * columns);
        EXPECT_EQ(diagnose(*mold->cast).components, 1) << "everything that solidifies is one piece";
        expectWaysOfOneLength(*mold);
        EXPECT_GE(mold->minWall, mold->settings.leastSteel - 1e-6);
        MoldSettings shortest = balancedGrid(rows, columns);
        shortest.spout.runners = Runners::Shortest;
        const Result<Mold> uneven = moldOf(frusta(20, 10, 5, 3, lean), shortest);
        ASSERT_TRUE(uneven);
        const auto [least, most] =
            std::minmax_element(uneven->pathLengths.begin(), uneven->pathLengths.end());
        EXPECT_TRUE(*most - *least > 1 || rows * columns == 2);
    }
}

TEST(BalancedRunners, HaveRoomBetweenSmallCavitiesToo) {
    for (const auto& [rows, columns] : {std::pair{1, 4}, {4, 2}}) {
        MoldSettings settings = balancedGrid(rows, columns);
        settings.layout.spacing = 2;
        settings.spout.diameter = 14;
        settings.spout.gate = 2;
        const Result<Mold> mold = moldOf(frusta(7, 4, 3, 2, lean), settings);
        expectVerified(mold);
        expectWaysOfOneLength(*mold);
        EXPECT_GE(mold->minWall, mold->settings.leastSteel - 1e-6);
    }
}

TEST(BalancedRunners, LeaveAlongDirectionsOffTheNormal) {
    for (const auto& [rows, columns] : {std::pair{2, 2}, {1, 4}}) {
        const Result<Mold> mold = moldOf(sheared(ball(12, 4), 0.3, -0.2), balancedGrid(rows, columns));
        expectVerified(mold);
        expectWaysOfOneLength(*mold);
        EXPECT_GE(mold->minWall, mold->settings.leastSteel - 1e-6);
    }
}

TEST(BalancedRunners, AreAsLongToCavitiesThatAreNotAlike) {
    MoldSettings settings = balancedGrid(2, 2);
    settings.layout.alternation = Alternation::Turn;
    // Its highest place is off its middle, so every second gate stands elsewhere.
    IndexedMesh lopsided = frusta(20, 10, 5, 3, lean).mesh;
    lopsided.V.col(1) += 0.2 * lopsided.V.col(0);
    KnownCast cast = frusta(20, 10, 5, 3, lean);
    cast.mesh = lopsided;
    const Result<Mold> mold = moldOf(cast, settings);
    expectVerified(mold);
    expectWaysOfOneLength(*mold);
}

TEST(BalancedRunners, AreRefusedWithAReason) {
    const KnownCast cast = frusta(20, 10, 5, 3, lean);
    const auto refused = [&](const MoldSettings& settings, const KnownCast& of, const char* because) {
        const Result<Mold> mold = moldOf(of, settings);
        ASSERT_FALSE(mold);
        EXPECT_EQ(mold.error().code, ErrorCode::Impossible);
        EXPECT_NE(mold.error().english().find(because), std::string::npos) << mold.error().english();
    };
    refused(balancedGrid(3, 2), cast, "3 and 2");
    refused(balancedGrid(1, 6), cast, "1 and 6");
    MoldSettings staggered = balancedGrid(2, 2);
    staggered.layout.arrangement = Arrangement::Staggered;
    refused(staggered, cast, "straight");
    KnownCast two = cast;
    IndexedMesh second = frusta(8, 6, 4, 2, lean).mesh;
    second.V.col(0).array() += 22;
    two.mesh = together(cast.mesh, second);
    refused(balancedGrid(2, 2), two, "2 solids");
}

TEST(BalancedRunners, AreNotAskedForWithoutRunners) {
    const KnownCast cast = frusta(20, 10, 5, 3, lean);
    expectVerified(moldOf(cast, balancedGrid(1, 1)));
    MoldSettings circle = balancedGrid(1, 3);
    circle.layout.arrangement = Arrangement::Circle;
    expectVerified(moldOf(cast, circle));
    MoldSettings lying = balancedGrid(1, 3);
    lying.spout.resting = Resting::Lying;
    expectVerified(moldOf(cast, lying));
}

TEST(BalancedRunners, AreSketchedAsTheyAreBuilt) {
    const KnownCast cast = frusta(20, 10, 5, 3, lean);
    MoldSettings settings = balancedGrid(2, 4);
    Result<MoldSketcher> sketcher = MoldSketcher::prepared(test::trayOf(cast), 1, settings);
    ASSERT_TRUE(sketcher);
    settings.placed = {{Placeable::Key, 1, {2, 3}}};
    const Result<MoldSketch> sketch = sketcher->sketch(settings.placed);
    const Result<Mold> mold = moldOf(cast, settings);
    ASSERT_TRUE(sketch);
    ASSERT_EQ(mold.has_value(), sketch->steel.front().thickness > 0);
    const Result<MoldSketch> free = sketcher->sketch({});
    settings.placed.clear();
    const Result<Mold> built = moldOf(cast, settings);
    ASSERT_TRUE(free && built);
    EXPECT_EQ(free->steel, built->steelOfEach);
    EXPECT_EQ(free->features.size(), built->features.size());
}

TEST(BalancedRunners, TellThatASpoutByHandIsNotFollowed) {
    for (const bool circle : {false, true}) {
        MoldSettings settings = everyFeature();
        settings.layout.rows = settings.layout.columns = 2;
        settings.spout.runners = Runners::Balanced;
        if (circle)
            settings.layout.arrangement = Arrangement::Circle;
        settings.placed = {{Placeable::Spout, 0, {7, 40}}};
        const Result<Mold> mold = moldOf(ball(8, 4), settings);
        expectVerified(mold);
        ASSERT_TRUE(mold);
        EXPECT_TRUE(std::ranges::any_of(mold->notes, [](const Message& note) {
            return note.english().find("not where it was put") != std::string::npos;
        }));
    }
}

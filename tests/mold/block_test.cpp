// SPDX-License-Identifier: AGPL-3.0-or-later
// The block's outside: outer faces with draft, and shells.
#include "mold/block.h"

#include "support/casts.h"
#include "support/molds.h"
#include "support/plan_area.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double grid = 1.0 / 65536;
const Directions upright{Vector3d::UnitZ(), -Vector3d::UnitZ()};
const double lean = std::tan(radians(5));

Block boxOf(const Vector3d& low, const Vector3d& high, double outerDraft) {
    MoldSettings settings;
    settings.wall = settings.floor = settings.ceiling = 5;
    settings.step = 0;
    settings.outerDraft = outerDraft;
    BlockContent content;
    content.cavities = {low, high};
    return blockAround(content, settings, {upright, grid}).value();
}

/// Volume of a body a × b at the plane whose walls go outwards by k per mm of its height h.
double flared(double a, double b, double h, double k) {
    return a * b * h + (a + b) * k * h * h + 4.0 / 3 * k * k * h * h * h;
}

double steelToOutside(const Mold& mold) {
    for (const ThinSteel& thin : mold.steel)
        if (thin.first == "Cavity" && thin.second == "outside")
            return thin.thickness;
    return 0;
}

} // namespace

TEST(OuterDraft, WidensTheBlockToItsBacks) {
    const Block block = boxOf({-10, -15, -3}, {10, 15, 5}, 4);
    const double k = std::tan(radians(4.01));
    EXPECT_NEAR(block.volume(), flared(30, 40, 10, k) + flared(30, 40, 8, k), 1e-2);
    EXPECT_NEAR(block.box().sizes().x(), 30 + 2 * 10 * k, 1e-4);
    EXPECT_NEAR(block.depthOf(Vector3d(10, 0, 0)), 5 * std::cos(std::atan(k)), 1e-4);
    EXPECT_NEAR(block.depthOf(Vector3d(10, 0, 5)), 5, 1e-4) << "its back is nearer";
    EXPECT_NEAR(block.depthOf(Vector2d(10, 0)), 5, 1e-9);
    EXPECT_NEAR(block.flare(Vector2d::UnitX())[1], k, 1e-9);
}

TEST(OuterDraft, BelowZeroNarrowsTheBlockAndKeepsItsWalls) {
    const Block block = boxOf({-10, -15, -3}, {10, 15, 5}, -4);
    const double k = std::tan(radians(4.01));
    const double width = 30 + 2 * 10 * k;
    const double length = 40 + 2 * 10 * k;
    EXPECT_NEAR(block.volume(), flared(width, length, 10, -k) + flared(width, length, 8, -k), 0.05);
    EXPECT_NEAR(block.depthOf(Vector2d(10, 0)), 5, 1e-4) << "at the back";
}

TEST(OuterDraft, OfAMoldIsProvedAndAddsUp) {
    MoldSettings settings;
    settings.step = 0;
    settings.outerDraft = 3;
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), settings);
    expectVerified(mold);
    const double k = std::tan(radians(3.01));
    EXPECT_NEAR(mold->blockVolume, flared(20, 30, 10, k) + flared(20, 30, 8, k), 1e-2);
    EXPECT_NEAR(mold->half1.volume + mold->half2.volume, mold->blockVolume - mold->cavityVolume, 1e-2);
}

TEST(OuterDraft, GoesWithEveryFeature) {
    for (const double draft : {6.0, -6.0})
        for (const BlockShape shape : {BlockShape::Box, BlockShape::Shell})
            for (const int columns : {1, 2}) {
                MoldSettings settings = everyFeature();
                settings.bolts.count = 2;
                settings.layout.columns = columns;
                settings.outerDraft = draft;
                settings.shape = shape;
                expectVerified(moldOf(ball(12, 4), settings));
                expectVerified(moldOf(sheared(ball(12, 4), 0.35, -0.3), settings));
                settings.spout.resting = Resting::Lying;
                expectVerified(moldOf(sheared(ball(12, 4), 0.3, 0.3), settings));
            }
}

TEST(OuterDraft, LeavesAlongObliqueDirections) {
    // Directions 20° off the normal: a wall that leans by the draft alone would hold on one side.
    MoldSettings settings;
    settings.outerDraft = 2;
    const Result<Mold> mold = moldOf(sheared(frusta(20, 10, 5, 3, lean), std::tan(radians(20)), 0), settings);
    expectVerified(mold);
    const double h1 = mold->half1.size.z();
    const double h2 = mold->half2.size.z();
    double most = 0;
    for (const int axis : {0, 1}) {
        const double inPlane = mold->half2.size[axis] - 2 * h2 * std::tan(radians(2.01));
        most = std::max(most, mold->half1.size[axis] - inPlane);
    }
    EXPECT_NEAR(most, h1 * std::tan(radians(22.01)), 1e-3)
        << "the wall that the half leaves over; not the one behind";
}

TEST(Machines, TooSmallForAMoldAreTold) {
    MoldSettings settings;
    settings.machines = {{35, 25, 20}, 0.001};
    const auto told = [&](const char* words) {
        const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), settings);
        expectVerified(mold);
        return std::count_if(mold->notes.begin(), mold->notes.end(), [&](const Message& note) {
            return note.english().find(words) != std::string::npos;
        });
    };
    EXPECT_EQ(told("larger than the printer's"), 0) << "20 × 30, turned";
    EXPECT_EQ(told("the press has"), 1);
    settings.machines = {{35, 19, 20}, 1000};
    EXPECT_EQ(told("larger than the printer's"), 2);
    EXPECT_EQ(told("the press has"), 0);
}

TEST(Shell, OfABallIsRoundButForItsFoot) {
    MoldSettings settings;
    settings.step = 0;
    settings.shape = BlockShape::Shell;
    const Result<Mold> mold = moldOf(ball(15, 4), settings);
    expectVerified(mold);
    EXPECT_GE(steelToOutside(*mold), 5 - 1e-4) << "no thinner than the box's walls";
    // 40 × 40 in the plane; a polygon of 32 sides round a circle of 20, and the foot's corners.
    const double box = 40 * 40;
    const double round = 32 * 400 * std::tan(std::numbers::pi / 32);
    const double height = mold->blockSize.z();
    EXPECT_LT(mold->blockVolume, (round + (box - round) / 4) * height);
    EXPECT_GT(mold->blockVolume, round * height);
    settings.shape = BlockShape::Box;
    EXPECT_NEAR(mold->savedVolume, moldOf(ball(15, 4), settings)->blockVolume - mold->blockVolume,
                1e-6 * mold->blockVolume);
}

TEST(Shell, IsConvexAndHoldsWhatItMust) {
    const Block box = boxOf({-20, -20, -5}, {20, 20, 5}, 0);
    MoldSettings settings;
    settings.shape = BlockShape::Shell;
    const PlanShape thing = planRectangle({5, 5}, {20, 18});
    const Block shell = shellOf(box, {{thing, 3}}, settings, {upright, grid}).value();
    for (const Vector2d& p : thing)
        EXPECT_GE(shell.depthOf(p), 3 - 1e-4);
    for (std::size_t k = 0; k < shell.body.base.size(); ++k) {
        const std::size_t n = shell.body.base.size();
        const Vector2d a = shell.body.base[(k + 1) % n] - shell.body.base[k];
        const Vector2d b = shell.body.base[(k + 2) % n] - shell.body.base[(k + 1) % n];
        EXPECT_GT(a.x() * b.y() - a.y() * b.x(), 0);
    }
    EXPECT_LT(test::planArea(shell.body.base), 0.8 * test::planArea(box.body.base));
    EXPECT_LE(shell.plan().min().x(), -12.5 + 1e-9) << "it stands on the middle half of its lower edge";
}

TEST(Shell, CutsOffNothingThatABoxNeeds) {
    for (const int columns : {1, 3}) {
        MoldSettings settings = everyFeature();
        settings.bolts.count = 2;
        settings.layout.columns = columns;
        const Result<Mold> box = moldOf(ball(12, 4), settings);
        settings.shape = BlockShape::Shell;
        const Result<Mold> shell = moldOf(ball(12, 4), settings);
        expectVerified(box);
        expectVerified(shell);
        EXPECT_LT(shell->blockVolume, box->blockVolume);
        EXPECT_GE(shell->minWall, settings.leastSteel - 1e-6);
        EXPECT_EQ(count(*shell, "key"), 4);
    }
}

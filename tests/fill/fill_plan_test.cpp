// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/fill_plan.h"

#include "base/parallel.h"
#include "castability/topology.h"
#include "filled_checks.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <numbers>
#include <numeric>

using namespace moldwright;

namespace {

constexpr double kPi = std::numbers::pi;

IndexedMesh shifted(IndexedMesh mesh, const Eigen::Vector3d& by) {
    mesh.V.rowwise() += by.transpose();
    return mesh;
}

IndexedMesh turnedOver(IndexedMesh mesh) {
    mesh.F.col(1).swap(mesh.F.col(2));
    return mesh;
}

IndexedMesh standingTorus(double x) {
    return shifted(test::rotated(test::torus(2, 0.7, 64, 48), Eigen::Vector3d::UnitY(), kPi / 2 - 0.1),
                   {x, 0, 0.05});
}

FillPlan planned(const IndexedMesh& mesh) {
    const auto plan = planFill(insertPartingLine(mesh, 0.1), {});
    EXPECT_TRUE(plan.has_value());
    return plan ? *plan : FillPlan{};
}

double ballVolume(double r) {
    return 4 * kPi * r * r * r / 3;
}

} // namespace

TEST(FillPlan, WhatNeedsNothingIsLeftAsItIs) {
    // Undercut below its equator, but a graph once bent.
    const FillPlan plan = planned(test::sphere({0, 0, 0.4}, 1, 4));
    ASSERT_EQ(plan.regions.size(), 1U);
    EXPECT_EQ(plan.regions[0].side, 1);
    EXPECT_FALSE(plan.regions[0].needed);
    EXPECT_NEAR(plan.regions[0].volume, plan.filled.volume, 1e-3 * plan.filled.volume);
    const auto least = minimalFill(plan);
    ASSERT_TRUE(least);
    EXPECT_NEAR(least->volume, 0, 1e-9);
    EXPECT_EQ(least->surface.mesh.faceCount(), plan.part.mesh.faceCount());
}

TEST(FillPlan, EachOfTwoStandingToriHasAHoleOfItsOwn) {
    const FillPlan plan = planned(test::together(standingTorus(-3), standingTorus(3)));
    const std::vector<int> needed = plan.needed();
    ASSERT_EQ(needed.size(), 2U);
    EXPECT_LT(plan.regions[static_cast<std::size_t>(needed[0])].place.x() *
                  plan.regions[static_cast<std::size_t>(needed[1])].place.x(),
              0);
    const auto least = minimalFill(plan);
    ASSERT_TRUE(least);
    EXPECT_TRUE(topologyAllowsCasting(least->surface.mesh, least->surface.labels));
    EXPECT_LE(least->volume, plan.filled.volume * (1 + 1e-6));
}

TEST(FillPlan, OneOfTwoHolesCanBeFilledAlone) {
    const FillPlan plan = planned(test::together(standingTorus(-3), standingTorus(3)));
    const std::vector<int> needed = plan.needed();
    ASSERT_EQ(needed.size(), 2U);
    const auto one = fillChosen(plan, {needed[0]});
    ASSERT_TRUE(one) << one.error().english();
    const FillRegion& region = plan.regions[static_cast<std::size_t>(needed[0])];
    EXPECT_NEAR(one->volume, region.volume, 1e-9 * ballVolume(1));
    EXPECT_FALSE(topologyAllowsCasting(one->surface.mesh, one->surface.labels));
    EXPECT_TRUE(diagnose(one->surface.mesh).selfIntersections.empty());
    // The other torus is still there as it was.
    const auto areaBeside = [&](const IndexedMesh& mesh) {
        double area = 0;
        for (int f = 0; f < mesh.faceCount(); ++f)
            if (mesh.corner(f, 0).x() * region.place.x() < 0)
                area += doubleAreaVector(mesh, f).norm() / 2;
        return area;
    };
    EXPECT_NEAR(areaBeside(one->surface.mesh), areaBeside(plan.part.mesh), 1e-9);
}

TEST(FillPlan, AClosedCavityIsARegionOfItsOwn) {
    const IndexedMesh hollow =
        test::together(test::sphere({0, 0, 0}, 2, 4), turnedOver(test::sphere({0, 0, 1}, 0.5, 3)));
    const FillPlan plan = planned(hollow);
    ASSERT_EQ(plan.needed().size(), 1U);
    const FillRegion& region = plan.regions[static_cast<std::size_t>(plan.needed()[0])];
    EXPECT_EQ(region.side, 1);
    EXPECT_NEAR(region.volume, ballVolume(0.5), 0.03 * ballVolume(0.5));
    EXPECT_NEAR(region.size, std::sqrt(3.0), 0.02);
    EXPECT_LT((region.place - Eigen::Vector3d(0, 0, 1)).norm(), 0.6);
    const auto least = minimalFill(plan);
    ASSERT_TRUE(least);
    EXPECT_NEAR(least->volume, region.volume, 1e-9);
}

TEST(FillPlan, WhatFloatsInACavityGoesWithIt) {
    const IndexedMesh cavity =
        test::together(test::sphere({0, 0, 0}, 3, 4), turnedOver(test::sphere({0, 0, 1.5}, 1, 4)));
    const FillPlan plan = planned(test::together(cavity, test::sphere({0.1, 0, 1.4}, 0.4, 3)));
    ASSERT_EQ(plan.needed().size(), 1U);
    const FillRegion& region = plan.regions[static_cast<std::size_t>(plan.needed()[0])];
    EXPECT_NEAR(region.volume, ballVolume(1) - ballVolume(0.4), 0.02 * ballVolume(1));
    const auto least = minimalFill(plan);
    ASSERT_TRUE(least);
    EXPECT_EQ(diagnose(least->surface.mesh).components, 1);
}

TEST(FillPlan, APieceThatFloatsGetsAFoot) {
    const IndexedMesh two = test::together(test::sphere({0, 0, 0}, 1, 4), test::sphere({3, 0, 2}, 0.5, 4));
    const FillPlan plan = planned(two);
    ASSERT_EQ(plan.needed().size(), 1U);
    const auto least = minimalFill(plan);
    ASSERT_TRUE(least);
    EXPECT_NEAR(least->volume, kPi * 0.25 * 2 - ballVolume(0.5) / 2, 0.05);
}

TEST(FillPlan, AllRegionsTogetherFillEverything) {
    const FillPlan plan = planned(standingTorus(0));
    std::vector<int> all(plan.regions.size());
    std::iota(all.begin(), all.end(), 0);
    const auto everything = fillChosen(plan, all);
    ASSERT_TRUE(everything);
    EXPECT_NEAR(everything->volume, plan.filled.volume, 1e-6 * plan.filled.volume);
    test::expectSound(*everything, {});
}

TEST(FillPlan, ALongUndercutIsDividedWhereItIsNarrow) {
    // A thick bar with a waist in its middle, floating on the plane: one undercut all round.
    IndexedMesh bar = test::sphere({0, 0, 0}, 1, 5);
    for (int v = 0; v < bar.vertexCount(); ++v) {
        const double waist = 0.4 + 0.6 * std::min(1.0, std::abs(bar.V(v, 0)) / 0.5);
        bar.V.row(v) = Eigen::RowVector3d(6 * bar.V(v, 0), waist * bar.V(v, 1), waist * bar.V(v, 2) + 0.3);
    }
    const FillPlan whole = planned(bar);
    const FillPlan parts = divided(whole, {});
    ASSERT_GT(parts.regions.size(), whole.regions.size());
    double sum = 0;
    for (int r = 0; r < static_cast<int>(parts.regions.size()); ++r) {
        const FillRegion& region = parts.regions[static_cast<std::size_t>(r)];
        sum += region.volume;
        EXPECT_LT(region.size, 0.45 * diagonal(bar));
        if (region.volume < 1e-3 * volume(bar))
            continue;
        const auto alone = fillChosen(parts, {r});
        ASSERT_TRUE(alone) << alone.error().english();
        EXPECT_NEAR(alone->volume, region.volume, 1e-6 * volume(bar));
    }
    EXPECT_NEAR(sum, whole.filled.volume, 1e-6 * volume(bar));
    std::vector<int> all(parts.regions.size());
    std::iota(all.begin(), all.end(), 0);
    const auto everything = fillChosen(parts, all);
    ASSERT_TRUE(everything);
    EXPECT_NEAR(everything->volume, sum, 1e-6 * volume(bar));
    test::expectSound(*everything, {});
}

TEST(FillPlan, OnlyWhatAnArchSpansIsNeeded) {
    // A ring that stands in a long bar: the bar is undercut along its sides, and the arch over it needs them
    // not.
    const IndexedMesh bar = test::rotated(test::torus(6, 1, 96, 32), Eigen::Vector3d::UnitX(), 0.02);
    const IndexedMesh raised = shifted(bar, {0, 0, 0.6});
    const FillPlan plan = planned(test::together(raised, shifted(standingTorus(0), {14, 0, 0})));
    const std::vector<int> needed = plan.needed();
    ASSERT_FALSE(needed.empty());
    for (const int r : needed)
        EXPECT_GT(plan.regions[static_cast<std::size_t>(r)].place.x(), 10) << "none of the lying ring";
}

TEST(FillPlan, AnUndercutIsDividedWhereItIsNarrow) {
    // Two rings, joined under water by a bar that hangs over: one undercut, of which only the holes are
    // needed.
    IndexedMesh part = test::splitInFour(
        test::splitInFour(test::splitInFour(test::splitInFour(test::box({-4, -0.5, 1}, {4, 0.5, 2})))));
    part = test::together(part, test::box({-0.3, -0.3, -1}, {0.3, 0.3, 0.9}));
    const FillPlan plan = planned(part);
    double all = 0;
    for (const FillRegion& region : plan.regions)
        all += region.volume;
    EXPECT_NEAR(all, plan.filled.volume, 1e-6 * all);
    const auto least = minimalFill(plan);
    ASSERT_TRUE(least);
    EXPECT_TRUE(topologyAllowsCasting(least->surface.mesh, least->surface.labels));
    // It needs to stand on something, not on a wall below its whole length.
    EXPECT_GT(least->volume, 0);
    EXPECT_LT(least->volume, 0.7 * plan.filled.volume);
    const IndexedMesh& mesh = least->surface.mesh;
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            EXPECT_GT((mesh.corner(f, k) - mesh.corner(f, (k + 1) % 3)).norm(), 1e-5)
                << "no edge too short to "
                   "fill with tetrahedra";
    EXPECT_TRUE(diagnose(least->surface.mesh).selfIntersections.empty());
}

TEST(FillPlan, WheneverItIsStoppedItSaysSoOrIsDone) {
    const PartedMesh part = insertPartingLine(standingTorus(0), 0.1);
    const auto whole = planFill(part, {});
    ASSERT_TRUE(whole);
    int cancelled = 0;
    for (int i = 0; i < 12; ++i) {
        const Task task;
        task.setDeadline(std::chrono::steady_clock::now() + std::chrono::milliseconds(20 * i));
        const auto plan = planFill(part, {}, task);
        if (!plan) {
            ++cancelled;
            EXPECT_EQ(plan.error().code, ErrorCode::Cancelled);
        } else if (!task.stopped()) {
            EXPECT_EQ(plan->needed(), whole->needed());
        }
    }
    EXPECT_GT(cancelled, 0);
}

TEST(FillPlan, IsTheSameForAnyNumberOfThreads) {
    setThreadCount(1);
    const auto one = minimalFill(planned(standingTorus(0)));
    setThreadCount(4);
    const auto four = minimalFill(planned(standingTorus(0)));
    setThreadCount(0);
    ASSERT_TRUE(one && four);
    EXPECT_EQ(one->surface.mesh.V, four->surface.mesh.V);
    EXPECT_EQ(one->surface.mesh.F, four->surface.mesh.F);
    EXPECT_EQ(one->sourceVertex, four->sourceVertex);
}

TEST(FillPlan, DividingLeavesNoTriangleThatIsALine) {
    // Cuts along planes square to the rows of the ring's faces: cut points lie on edges of whole neighbours.
    const IndexedMesh ring =
        shifted(test::rotated(test::torus(4, 1.2, 40, 20), Eigen::Vector3d::UnitX(), kPi / 2), {-10, 0, 4});
    const auto least = minimalFill(planned(test::together(ring, test::sphere({10, 0, 1}, 3, 3))));
    ASSERT_TRUE(least);
    const IndexedMesh& mesh = least->surface.mesh;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        double longest = 0;
        for (int k = 0; k < 3; ++k)
            longest = std::max(longest, (mesh.corner(f, k) - mesh.corner(f, (k + 1) % 3)).norm());
        EXPECT_GT(doubleAreaVector(mesh, f).norm() / longest, 1e-8) << f;
    }
}

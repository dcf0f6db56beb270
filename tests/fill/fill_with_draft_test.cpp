// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/parallel.h"
#include "fill/fill.h"
#include "filled_checks.h"
#include "mesh/measures.h"
#include "support/shapes.h"
#include "voxels.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

using namespace moldwright;

namespace {

constexpr double kDraft = 2;

Directions tilted() {
    return {Eigen::Vector3d(0.3, -0.1, 1).normalized(), Eigen::Vector3d(0.1, 0.25, -1).normalized()};
}

PartedMesh partedAt(const IndexedMesh& mesh, double planeHeight) {
    IndexedMesh moved = mesh;
    moved.V.col(2).array() -= planeHeight;
    return insertPartingLine(moved, 0.02);
}

FilledPart drafted(const PartedMesh& part, const Directions& directions = {}) {
    const auto result = fillWithDraft(part, directions, kDraft);
    EXPECT_TRUE(result.has_value());
    if (!result)
        return {};
    test::expectSound(*result, directions);
    return *result;
}

/// A ball pressed in and out by waves: undercut on all sides.
IndexedMesh lump(unsigned seed) {
    IndexedMesh mesh = test::sphere({0, 0, 0}, 1, 4);
    std::mt19937 random(seed);
    Eigen::Matrix<double, 5, 4> waves;
    for (double& w : waves.reshaped())
        w = static_cast<double>(random()) / 4294967296.0 * 2 - 1;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        double sum = 0;
        for (int k = 0; k < 5; ++k)
            sum += std::sin(6 * waves.row(k).head<3>().dot(mesh.V.row(v)) + 7 * waves(k, 3));
        mesh.V.row(v) *= 1 + 0.12 * sum;
    }
    return mesh;
}

double topAt(const IndexedMesh& mesh, const Eigen::Vector2d& foot) {
    double highest = 0;
    for (const double z : test::crossings(mesh, foot, Eigen::Vector3d::UnitZ()))
        highest = std::max(highest, z);
    return highest;
}

} // namespace

TEST(FillWithDraft, AroundABallStandsACone) {
    const double c = 0.5; // the centre's height above the plane
    const FilledPart filled = drafted(partedAt(test::sphere({0, 0, c}, 1, 5), 0));
    EXPECT_EQ(test::facesShort(filled, {}, kDraft), 0);
    // The skirt leaves the ball where it is as steep as the skirt, and so reaches the plane at this radius.
    const auto radius = [&](double degrees) {
        return 1 / std::cos(radians(degrees)) + c * std::tan(radians(degrees));
    };
    double foot = 0;
    for (const auto& [a, b] : partingEdges(filled.surface.mesh, filled.surface.labels))
        foot = std::max(foot, filled.surface.mesh.point(a).head<2>().norm());
    EXPECT_GT(foot, radius(kDraft) - 2e-3);
    EXPECT_LT(foot, radius(kDraft + 1));
}

TEST(FillWithDraft, ATableKeepsItsEdgesAndGetsItsSkirt) {
    std::vector<std::array<int, 3>> table = {{1, 1, -1}, {1, 1, 0}};
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 3; ++y)
            table.push_back({x, y, 1});
    const IndexedMesh mesh = test::voxels(table);
    const FilledPart filled = drafted(partedAt(mesh, 0));
    EXPECT_EQ(test::facesShort(filled, {}, kDraft), 0);
    EXPECT_NEAR(filled.volume, 8, 1e-3);
    // The table's top stays as it is, and so does its edge: outside it the body is lower at once.
    EXPECT_NEAR(topAt(filled.surface.mesh, {1.5, 2.9}), 2, 1e-6);
    EXPECT_LT(topAt(filled.surface.mesh, {1.5, 3.02}), 2 - 0.02 / std::tan(radians(kDraft + 1)));
    const double run = 2 * std::tan(radians(kDraft));
    EXPECT_GT(topAt(filled.surface.mesh, {1.5, 3 + 0.9 * run}), 0);
    EXPECT_EQ(topAt(filled.surface.mesh, {1.5, 3 + 1.6 * run}), 0);
}

TEST(FillWithDraft, AHollowCornerIsNotFilledMoreThanItsSkirts) {
    // Two high blocks about a corner of low ground.
    std::vector<std::array<int, 3>> blocks = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0},
                                              {1, 0, 1}, {0, 1, 0}, {0, 1, 1}};
    for (int x = 0; x < 2; ++x)
        for (int y = 0; y < 2; ++y)
            blocks.push_back({x, y, -1});
    const FilledPart filled = drafted(partedAt(test::voxels(blocks), 0));
    EXPECT_EQ(test::facesShort(filled, {}, kDraft), 0);
    const double run = 2 * std::tan(radians(kDraft + 1));
    EXPECT_EQ(topAt(filled.surface.mesh, {1 + 1.2 * run, 1 + 1.2 * run}), 0);
}

TEST(FillWithDraft, LumpsLeaveAlongTiltedDirections) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
        SCOPED_TRACE(seed);
        const PartedMesh part = partedAt(lump(seed), 0.1);
        const FilledPart filled = drafted(part, tilted());
        EXPECT_LE(test::facesShort(filled, tilted(), kDraft), filled.surface.mesh.faceCount() / 200);
        EXPECT_GT(filled.volume, 0);
        EXPECT_GT(filled.skirtVolume, 0);
        EXPECT_NEAR(volume(filled.surface.mesh), volume(part.mesh) + filled.volume + filled.skirtVolume,
                    1e-9);
        const auto vertical = fill(part, tilted());
        ASSERT_TRUE(vertical);
        EXPECT_NEAR(filled.volume, vertical->volume, 1e-3);
    }
}

TEST(FillWithDraft, FarFromWallsEverythingStays) {
    const PartedMesh part = partedAt(lump(3), 0);
    const FilledPart filled = drafted(part);
    const auto vertical = fill(part, {});
    ASSERT_TRUE(vertical);
    std::mt19937 random(5);
    int same = 0;
    int compared = 0;
    for (int i = 0; i < 400; ++i) {
        const Eigen::Vector2d foot(static_cast<double>(random()) / 4294967296.0 * 3 - 1.5,
                                   static_cast<double>(random()) / 4294967296.0 * 3 - 1.5);
        const double before = topAt(vertical->surface.mesh, foot);
        const double after = topAt(filled.surface.mesh, foot);
        EXPECT_GE(after, before - 2e-3) << foot.transpose();
        compared += before > 0 ? 1 : 0;
        same += before > 0 && std::abs(after - before) < 1e-5 ? 1 : 0;
    }
    EXPECT_GT(same, 0.7 * compared);
}

TEST(FillWithDraft, IsTheSameForAnyNumberOfThreads) {
    const PartedMesh part = partedAt(lump(7), 0);
    setThreadCount(1);
    const auto one = fillWithDraft(part, tilted(), kDraft);
    setThreadCount(4);
    const auto four = fillWithDraft(part, tilted(), kDraft);
    setThreadCount(0);
    ASSERT_TRUE(one && four);
    EXPECT_EQ(one->surface.mesh.V, four->surface.mesh.V);
    EXPECT_EQ(one->surface.mesh.F, four->surface.mesh.F);
}

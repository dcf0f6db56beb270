// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/fill.h"

#include "base/parallel.h"
#include "filled_checks.h"
#include "mesh/measures.h"
#include "mesh/orient.h"
#include "support/shapes.h"
#include "voxels.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

using namespace moldwright;

namespace {

constexpr double kPi = std::numbers::pi;

FilledPart filledAt(const IndexedMesh& mesh, double planeHeight, const Directions& directions = {}) {
    IndexedMesh moved = mesh;
    moved.V.col(2).array() -= planeHeight;
    const auto result = fill(insertPartingLine(moved, 0.02), directions);
    EXPECT_TRUE(result.has_value());
    if (!result)
        return {};
    test::expectSound(*result, directions);
    return *result;
}

/// A lump without overlap that is undercut nearly everywhere: a sphere, its points moved in and out.
IndexedMesh lump(unsigned seed, double depth) {
    IndexedMesh mesh = test::sphere({0, 0, 0}, 1, 4);
    std::mt19937 random(seed);
    const auto draw = [&] { return static_cast<double>(random()) / 4294967296.0 * 2 - 1; };
    Eigen::Matrix<double, 5, 4> waves;
    for (double& w : waves.reshaped())
        w = draw();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        double sum = 0;
        for (int k = 0; k < 5; ++k)
            sum += std::sin(6 * waves.row(k).head<3>().dot(mesh.V.row(v)) + 7 * waves(k, 3));
        mesh.V.row(v) *= 1 + depth * sum / 3;
    }
    return mesh;
}

Directions tilted() {
    return {Eigen::Vector3d(0.3, -0.1, 1).normalized(), Eigen::Vector3d(0.1, 0.25, -1).normalized()};
}

} // namespace

TEST(Fill, NothingIsFilledWhereNothingIsUndercut) {
    const FilledPart filled = filledAt(test::sphere({0, 0, 0}, 1, 3), 0);
    EXPECT_NEAR(filled.volume, 0, 1e-6);
    EXPECT_TRUE(std::none_of(filled.surface.sourceFace.begin(), filled.surface.sourceFace.end(),
                             [](int f) { return f < 0; }));
}

TEST(Fill, BelowASpheresEquatorStandsACylinder) {
    const double r = 1;
    const double c = 0.5; // the centre's height above the plane
    const FilledPart filled = filledAt(test::sphere({0, 0, c}, r, 5), 0);
    const double zone = kPi * (r * r * c - c * c * c / 3);
    EXPECT_NEAR(filled.volume, kPi * r * r * c - zone, 0.01 * zone);
}

TEST(Fill, AStandingTorusLosesItsHole) {
    const double R = 2;
    const double r = 0.7;
    const IndexedMesh upright = test::rotated(test::torus(R, r, 96, 64), Eigen::Vector3d::UnitY(), kPi / 2);
    const FilledPart filled = filledAt(upright, 0);
    const double whole = kPi * (2 * r * R * R + kPi * R * r * r + 4 * r * r * r / 3);
    EXPECT_NEAR(volume(filled.surface.mesh), whole, 0.01 * whole);
}

TEST(Fill, AnArchIsFilledToTheGround) {
    std::vector<std::array<int, 3>> arch = {{0, 0, 0}, {0, 0, 1}, {3, 0, 0}, {3, 0, 1}};
    for (int x = 0; x < 4; ++x)
        arch.push_back({x, 0, 2});
    const FilledPart filled = filledAt(test::voxels(arch), 0);
    EXPECT_NEAR(filled.volume, 4, 1e-5);
    EXPECT_NEAR(volume(filled.surface.mesh), 12, 1e-5);
}

TEST(Fill, AnInnerCavityVanishesOnBothSidesOfThePlane) {
    std::vector<std::array<int, 3>> block;
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 4; ++y)
            for (int z = 0; z < 4; ++z)
                if (x % 3 == 0 || y % 3 == 0 || z % 3 == 0)
                    block.push_back({x, y, z});
    EXPECT_NEAR(filledAt(test::voxels(block), 1.5).volume, 8, 1e-5);
    EXPECT_NEAR(filledAt(test::voxels(block), 0.5).volume, 8, 1e-5);
}

TEST(Fill, AClosedPieceThatFloatsGetsAFoot) {
    const IndexedMesh two = test::together(test::box({0, 0, -1}, {1, 1, 1}), test::box({3, 0, 2}, {4, 1, 3}));
    const FilledPart filled = filledAt(two, 0);
    EXPECT_NEAR(filled.volume, 2, 1e-5);
}

TEST(Fill, AStaircaseHangingOverIsFilledStepByStep) {
    // Steps that climb outwards: every one hangs over the one before.
    std::vector<std::array<int, 3>> stair;
    for (int z = -1; z < 4; ++z)
        for (int x = 0; x <= std::max(z, 0); ++x)
            stair.push_back({x, 0, z});
    EXPECT_NEAR(filledAt(test::voxels(stair), 0).volume, 3 + 2 + 1, 1e-5);
}

TEST(Fill, StackedBoxesShareTheirVerticalEdges) {
    // A cross on a post: edges of the upper storey lie exactly above those of the lower one.
    std::vector<std::array<int, 3>> cubes = {{0, 0, -1}, {0, 0, 0}, {0, 0, 1}, {0, 0, 2}};
    for (const auto& arm : {std::array{1, 0}, std::array{-1, 0}, std::array{0, 1}, std::array{0, -1}})
        cubes.push_back({arm[0], arm[1], 1});
    const FilledPart filled = filledAt(test::voxels(cubes), 0);
    EXPECT_NEAR(filled.volume, 4, 1e-5);
}

TEST(Fill, HeightsAreThoseOfTheOutermostSurface) {
    const Directions directions = tilted();
    const PartedMesh part = insertPartingLine(lump(3, 0.3), 0.1);
    const auto filled = fill(part, directions);
    ASSERT_TRUE(filled);
    std::mt19937 random(5);
    int compared = 0;
    for (int i = 0; i < 400; ++i) {
        const Eigen::Vector2d foot(static_cast<double>(random()) / 4294967296.0 * 3 - 1.5,
                                   static_cast<double>(random()) / 4294967296.0 * 3 - 1.5);
        for (const int side : {1, 2}) {
            const double up = side == 1 ? 1 : -1;
            const auto top = [&](const IndexedMesh& mesh) {
                double highest = 0;
                for (const double z : test::crossings(mesh, foot, directions.of(side)))
                    highest = std::max(highest, up * z);
                return highest;
            };
            const double expected = top(part.mesh);
            EXPECT_NEAR(top(filled->surface.mesh), expected, 1e-5) << foot.transpose() << " side " << side;
            // And solid all the way down: above the plane the line leaves the body once.
            int exits = 0;
            for (const double z : test::crossings(filled->surface.mesh, foot, directions.of(side)))
                exits += up * z > 1e-6 ? 1 : 0;
            EXPECT_EQ(exits, expected > 1e-6 ? 1 : 0);
            compared += expected > 0 ? 1 : 0;
        }
    }
    EXPECT_GT(compared, 300);
}

TEST(Fill, RandomLumpsBecomeSound) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        const double before = volume(lump(seed, 0.35));
        const FilledPart filled = filledAt(lump(seed, 0.35), 0.2, tilted());
        EXPECT_NEAR(volume(filled.surface.mesh), before + filled.volume, 1e-3 * before);
        EXPECT_GT(filled.volume, 0);
    }
}

TEST(Fill, KeptPointsAndFacesNameTheirSource) {
    const PartedMesh part = insertPartingLine(lump(4, 0.3), 0.1);
    const auto filled = fill(part, tilted());
    ASSERT_TRUE(filled);
    const IndexedMesh& mesh = filled->surface.mesh;
    int keptPoints = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        if (const int source = filled->sourceVertex[static_cast<std::size_t>(v)]; source >= 0) {
            ++keptPoints;
            EXPECT_LT((mesh.point(v) - part.mesh.point(source)).norm(), 1e-6);
        }
    EXPECT_GT(keptPoints, part.mesh.vertexCount() / 3);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const int source = filled->surface.sourceFace[static_cast<std::size_t>(f)];
        if (source < 0)
            continue;
        const auto& labels = part.labels;
        EXPECT_EQ(labels[static_cast<std::size_t>(source)],
                  filled->surface.labels[static_cast<std::size_t>(f)]);
    }
}

TEST(Fill, IsTheSameForAnyNumberOfThreads) {
    const PartedMesh part = insertPartingLine(lump(7, 0.4), 0.1);
    setThreadCount(1);
    const auto one = fill(part, tilted());
    setThreadCount(4);
    const auto four = fill(part, tilted());
    setThreadCount(0);
    ASSERT_TRUE(one && four);
    EXPECT_EQ(one->surface.mesh.V, four->surface.mesh.V);
    EXPECT_EQ(one->surface.mesh.F, four->surface.mesh.F);
    EXPECT_EQ(one->surface.labels, four->surface.labels);
}

TEST(Fill, CanBeCancelled) {
    const Task task;
    task.cancel();
    const auto result = fill(insertPartingLine(lump(1, 0.2), 0.1), {}, task);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
}

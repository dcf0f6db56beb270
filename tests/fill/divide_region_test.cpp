// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/divide_region.h"

#include "fill/fill_plan.h"
#include "fill/planar_cover.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "mesh/opposite_sides.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

using namespace moldwright;

namespace {

/// The choices about a ball that floats above the plane, beside another that lies in it.
ChoiceMesh floatingBall() {
    const IndexedMesh part = test::together(test::sphere({0, 0, 0}, 1, 4), test::sphere({3, 0, 2}, 0.8, 4));
    const auto plan = planFill(insertPartingLine(part, 0.1), {});
    EXPECT_TRUE(plan.has_value());
    return plan ? plan->choices : ChoiceMesh{};
}

double areaOf(const PlanarCover& cover) {
    double area = 0;
    for (const auto& t : cover.triangles) {
        const Eigen::Vector2d a = cover.points[static_cast<std::size_t>(t[0])];
        const Eigen::Vector2d u = cover.points[static_cast<std::size_t>(t[1])] - a;
        const Eigen::Vector2d v = cover.points[static_cast<std::size_t>(t[2])] - a;
        area += (u.x() * v.y() - u.y() * v.x()) / 2;
    }
    return area;
}

} // namespace

TEST(DivideRegion, EveryChoiceOfItsPartsIsASoundSurface) {
    ChoiceMesh choices = floatingBall();
    ASSERT_GE(choices.regions, 1);
    const std::vector<double> before = volumesOf(choices);
    const DividingPlane plane{Eigen::Vector3d(1, 0.2, 0).normalized(), 3.0123, 1};
    ASSERT_TRUE(divideRegion(choices, 0, plane));
    const std::vector<double> after = volumesOf(choices);
    ASSERT_EQ(after.size(), before.size() + 1);
    EXPECT_NEAR(after.front() + after.back(), before.front(), 1e-9);
    EXPECT_GT(after.back(), 0.1 * before.front());
    const std::vector<char> none(after.size(), 0);
    std::vector<int> choiceOf;
    const double empty = volume(surfaceWith(choices, none, choiceOf).mesh);
    for (int which = 0; which < 4; ++which) {
        SCOPED_TRACE(which);
        std::vector<char> filled = none;
        filled.front() = which & 1;
        filled.back() = which >> 1;
        const PartedMesh surface = surfaceWith(choices, filled, choiceOf);
        EXPECT_TRUE(closedManifold(surface.mesh.F, surface.mesh.vertexCount()));
        EXPECT_TRUE(selfIntersections(surface.mesh).empty());
        EXPECT_NEAR(volume(surface.mesh), empty + (which & 1) * after.front() + (which >> 1) * after.back(),
                    1e-9);
        EXPECT_EQ(choiceOf.size(), static_cast<std::size_t>(surface.mesh.faceCount()));
    }
}

TEST(DivideRegion, APlaneBesideTheRegionChangesNothing) {
    ChoiceMesh choices = floatingBall();
    const std::size_t faces = choices.faces.size();
    EXPECT_FALSE(divideRegion(choices, 0, {Eigen::Vector3d::UnitX(), 50, 1}));
    EXPECT_EQ(choices.faces.size(), faces);
}

TEST(PlanarCover, ARingIsCoveredBetweenItsBorders) {
    const std::vector<Eigen::Vector2d> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {1, 2}, {2, 2}, {2, 1}};
    const auto cover = coverBorder(points, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}});
    ASSERT_TRUE(cover);
    EXPECT_NEAR(areaOf(*cover), 15, 1e-12);
    EXPECT_EQ(cover->points.size(), points.size());
}

TEST(PlanarCover, ALoopThatCrossesItselfIsCoveredBothWaysRound) {
    const std::vector<Eigen::Vector2d> points{{0, 0}, {3, 2}, {3, 0}, {0, 1}};
    const auto cover = coverBorder(points, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
    ASSERT_TRUE(cover);
    ASSERT_EQ(cover->points.size(), 5U) << "the crossing is a point of its own";
    EXPECT_EQ(cover->chains[0], (std::vector<int>{0, 4, 1}));
    EXPECT_EQ(cover->chains[2], (std::vector<int>{2, 4, 3}));
    ASSERT_EQ(cover->triangles.size(), 2U);
    EXPECT_NEAR(areaOf(*cover), -1.5, 1e-12) << "0.5 one way, 2 the other";
}

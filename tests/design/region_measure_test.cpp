// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/region_measure.h"

#include "mesh/measures.h"
#include "support/shapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <numeric>

using namespace moldwright;

namespace {

const IndexedMesh& ball() {
    static const IndexedMesh mesh = test::sphere({0, 0, 0}, 10, 3);
    return mesh;
}

std::vector<int> numbersTo(int count) {
    std::vector<int> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

/// The cap above z = 6, allowed to change by 0.1 mm.
KeptRegion cap() {
    KeptRegion region{"cap", {}, 0.1};
    for (int f = 0; f < ball().faceCount(); ++f)
        if (ball().corner(f, 0).z() > 6)
            region.faces.push_back(f);
    return region;
}

RegionMeasure measured(const IndexedMesh& cast) {
    return measureRegions({cap()}, ball(), numbersTo(ball().faceCount()), cast,
                          numbersTo(ball().vertexCount()))
        .front();
}

} // namespace

TEST(RegionMeasure, ARegionThatMovedAsAWholeKeptItsShape) {
    IndexedMesh cast = test::rotated(ball(), Eigen::Vector3d::UnitX(), 0.7);
    cast.V.rowwise() += Eigen::RowVector3d(3, -20, 5);
    const RegionMeasure cap = measured(cast);
    EXPECT_EQ(cap.name, "cap");
    EXPECT_LT(cap.maxDistance, 1e-9);
    EXPECT_LT(cap.strain, 1e-9);
    EXPECT_TRUE(cap.kept);
}

TEST(RegionMeasure, WhatHappensElsewhereDoesNotCount) {
    IndexedMesh cast = ball();
    for (int v = 0; v < cast.vertexCount(); ++v)
        if (cast.V(v, 2) < 0)
            cast.V.row(v) *= 0.5;
    EXPECT_LT(measured(cast).maxDistance, 1e-9);
}

TEST(RegionMeasure, AStretchedRegionIsTold) {
    IndexedMesh cast = ball();
    cast.V.col(0) *= 1.1;
    const RegionMeasure cap = measured(cast);
    EXPECT_GT(cap.strain, 0.05);
    EXPECT_LT(cap.strain, 0.1 + 1e-9);
    EXPECT_GT(cap.maxDistance, 0.1);
    EXPECT_LE(cap.rmsDistance, cap.maxDistance);
    EXPECT_FALSE(cap.kept);
}

TEST(RegionMeasure, ALimitIsComparedWithTheFarthestPoint) {
    IndexedMesh cast = ball();
    cast.V.col(0) *= 1.1;
    const RegionMeasure free =
        measureRegions({{"cap", cap().faces, 0}}, ball(), numbersTo(ball().faceCount()), cast,
                       numbersTo(ball().vertexCount()))
            .front();
    EXPECT_TRUE(free.kept); // only measured
    const double farthest = free.maxDistance;
    for (const double within : {0.99 * farthest, 1.01 * farthest})
        EXPECT_EQ(measureRegions({{"cap", cap().faces, within}}, ball(), numbersTo(ball().faceCount()), cast,
                                 numbersTo(ball().vertexCount()))
                      .front()
                      .kept,
                  within > farthest);
}

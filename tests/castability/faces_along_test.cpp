// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/faces_along.h"

#include "castability/mold_state.h"
#include "castability/overhang.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace moldwright;
using Eigen::Vector3d;

namespace {

std::vector<int> allFaces(const IndexedMesh& mesh) {
    std::vector<int> faces(static_cast<std::size_t>(mesh.faceCount()));
    std::iota(faces.begin(), faces.end(), 0);
    return faces;
}

std::vector<FacesAlong::Crossing> sortedCrossings(const IndexedMesh& mesh, const Vector3d& d,
                                                  const Vector3d& p) {
    std::vector<FacesAlong::Crossing> found;
    FacesAlong(mesh, allFaces(mesh), d).crossings(p, found);
    std::ranges::sort(found, {}, &FacesAlong::Crossing::way);
    return found;
}

} // namespace

TEST(FacesAlong, ALineGoesIntoAndOutOfEachSolid) {
    const IndexedMesh two = test::together(test::box({0, 0, 0}, {2, 2, 1}), test::box({0, 0, 3}, {2, 2, 5}));
    const auto found = sortedCrossings(two, Vector3d::UnitZ(), {0.7, 0.4, 2});
    ASSERT_EQ(found.size(), 4U);
    const std::vector<double> ways = {-2, -1, 1, 3};
    for (std::size_t i = 0; i < ways.size(); ++i) {
        EXPECT_NEAR(found[i].way, ways[i], 1e-12);
        EXPECT_EQ(found[i].along, i % 2 == 1);
    }
}

TEST(FacesAlong, AsManyInsAsOutsOnEveryObliqueLine) {
    const IndexedMesh ring = test::torus(10, 3, 60, 24);
    const Vector3d d = Vector3d(0.3, -0.5, 0.8).normalized();
    int met = 0;
    for (double x = -12.03; x < 12; x += 1.7)
        for (double y = -12.01; y < 12; y += 1.9) {
            const auto found = sortedCrossings(ring, d, {x, y, 0.2});
            met += found.empty() ? 0 : 1;
            for (std::size_t i = 0; i < found.size(); ++i)
                EXPECT_EQ(found[i].along, i % 2 == 1) << x << ' ' << y;
            EXPECT_EQ(found.size() % 2, 0U);
        }
    EXPECT_GT(met, 50);
}

TEST(Overhang, IsTheWayToTheOutermostFaceThatLooksAlong) {
    const IndexedMesh two = test::together(test::box({0, 0, 0}, {2, 2, 1}), test::box({0, 0, 3}, {2, 2, 5}));
    const Overhang over(two, allFaces(two), Vector3d::UnitZ());
    EXPECT_NEAR(over.above({0.7, 0.4, 2}), 3, 1e-12);
    EXPECT_NEAR(over.above({0.7, 0.4, 6}), 0, 1e-12);
    EXPECT_EQ(over.above({7, 7, 0}), 0);
}

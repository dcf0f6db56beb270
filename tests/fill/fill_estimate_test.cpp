// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/fill_estimate.h"

#include "fill/fill.h"
#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

using Eigen::Vector3d;

constexpr double kTolerance = 0.02;

} // namespace

TEST(FillEstimate, IsNothingWhereNothingIsUndercut) {
    EXPECT_NEAR(estimatedFill(test::sphere({3, -2, 1}, 5, 5), {{Vector3d::UnitZ(), 1}, {}}), 0, kTolerance);
}

TEST(FillEstimate, OfASphereCutOffItsMiddleIsTheRingBesideIt) {
    // Below the plane, at half the radius, a cylinder with half a ball under it; above, a cap as it is.
    const double envelope = 0.5 + 2.0 / 3 + 0.25 * 2.5 / 3;
    const double expected = (envelope - 4.0 / 3) / (4.0 / 3);
    for (const Vector3d& n :
         {Vector3d(0, 0, 1), Vector3d(0, -1, 0), Vector3d(1, 2, -2).normalized().eval()}) {
        const PartingPlane plane{n, 0.5};
        EXPECT_NEAR(estimatedFill(test::sphere({0, 0, 0}, 1, 5), {plane, Directions::normalTo(plane)}),
                    expected, kTolerance);
    }
}

TEST(FillEstimate, IsWhatFillingTakes) {
    const Directions tilted{Vector3d(0.3, -0.1, 1).normalized(), Vector3d(0.1, 0.25, -1).normalized()};
    const IndexedMesh ring = test::torus(0.3, 0.1, 48, 24);
    for (const double angle : {0.3, 0.8, 1.4}) {
        const IndexedMesh leaning = test::rotated(ring, Vector3d(1, 0.4, 0).normalized(), angle);
        const Result<FilledPart> filled = fill(insertPartingLine(leaning, 0.02), tilted);
        ASSERT_TRUE(filled);
        const double share = filled->volume / volume(leaning);
        EXPECT_GT(share, 2 * kTolerance);
        EXPECT_NEAR(estimatedFill(leaning, {{Vector3d::UnitZ(), 0}, tilted}), share,
                    kTolerance * (1 + share));
    }
}

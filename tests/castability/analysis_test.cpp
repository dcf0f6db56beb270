// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/analysis.h"

#include "castability/energy.h"
#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace moldwright;

namespace {

/// A mushroom: a 2×2×2 stem from z = −1 to 1 under a 4×4 cap from z = 1 to 2, as boxes that touch are not
/// joined but measured all the same.
IndexedMesh mushroom() {
    return test::together(test::box({-1, -1, -1}, {1, 1, 1}), test::box({-2, -2, 1}, {2, 2, 2}));
}

} // namespace

TEST(DraftAnalysis, MeasuresTheUndercutUnderACap) {
    const DraftAnalysis analysis = analyzeDraft(mushroom(), MoldState{}, 0);
    // The cap's underside looks down on side 1.
    EXPECT_NEAR(analysis.violatingArea, 16, 1e-12);
    EXPECT_EQ(analysis.worstDraftDegrees, -90);
    ASSERT_EQ(analysis.undercuts.size(), 1U);
    EXPECT_EQ(analysis.undercuts[0].side, 1);
    EXPECT_NEAR(analysis.undercuts[0].area, 16, 1e-12);
    EXPECT_NEAR(analysis.undercuts[0].depth, 1, 1e-12);
    EXPECT_TRUE(analysis.undercuts[0].place.isApprox(Eigen::Vector3d(0, 0, 1)));
}

TEST(DraftAnalysis, EnergyIsTheScaledCastabilityEnergy) {
    const IndexedMesh shape = test::torus(3, 1, 30, 20);
    MoldState state;
    state.plane.normal = Eigen::Vector3d(1, 0.2, 0.4).normalized();
    state.directions = Directions::normalTo(state.plane);
    const DraftAnalysis analysis = analyzeDraft(shape, state, 2);
    const double size = diagonal(shape);
    EXPECT_NEAR(analysis.energy, castabilityEnergy(shape, state, std::sin(radians(2))) / (size * size),
                1e-15);
}

TEST(DraftAnalysis, HistogramHoldsAllOfTheArea) {
    const DraftAnalysis analysis = analyzeDraft(test::sphere({0, 0, 0}, 1, 4), MoldState{}, 1);
    const auto& shares = analysis.histogram.areaFraction;
    EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-12);
    // Area of a sphere above latitude 30° on both sides: half.
    EXPECT_NEAR(shares.back(), 0.5, 0.02);
}

TEST(DraftAnalysis, CastableShapeHasNoUndercut) {
    IndexedMesh frustum = test::box({-1, -1, 0}, {1, 1, 1});
    for (int v = 4; v < 8; ++v)
        frustum.V.row(v).head<2>() *= 0.9;
    const DraftAnalysis analysis = analyzeDraft(frustum, MoldState{}, 5);
    EXPECT_TRUE(analysis.castable());
    EXPECT_TRUE(analysis.undercuts.empty());
    EXPECT_NEAR(analysis.worstDraftDegrees, degrees(std::atan(0.1)), 1e-9);
}

TEST(UndercutDepths, AreZeroButUnderTheCapAndTellHowMuchIsOverIt) {
    const IndexedMesh shape = mushroom();
    const std::vector<double> depths = undercutDepths(shape, MoldState{}, 0);
    const DraftAnalysis analysis = analyzeDraft(shape, MoldState{}, 0);
    ASSERT_EQ(depths.size(), static_cast<std::size_t>(shape.faceCount()));
    for (std::size_t f = 0; f < depths.size(); ++f)
        EXPECT_NEAR(depths[f], analysis.violating[f] ? 1 : 0, 1e-12) << f;
}

TEST(UndercutDepths, TheLargestIsThatOfItsRegion) {
    const IndexedMesh ring = test::torus(3, 1, 40, 24);
    MoldState state;
    state.plane.normal = Eigen::Vector3d(1, 0.2, 0.4).normalized();
    state.directions = Directions::normalTo(state.plane);
    const std::vector<double> depths = undercutDepths(ring, state, 2);
    for (const Undercut& undercut : analyzeDraft(ring, state, 2).undercuts) {
        double largest = 0;
        for (const int f : undercut.faces)
            largest = std::max(largest, depths[static_cast<std::size_t>(f)]);
        EXPECT_EQ(largest, undercut.depth);
    }
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/cast_analysis.h"

#include "support/casts.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

DraftAnalysis analysed(const test::KnownCast& cast, double draft) {
    const SideLabels labels = labelSides(cast.mesh, cast.state.plane);
    return analyzeCast(cast.mesh, labels, cast.state, draft, certify(cast.mesh, labels, cast.state, draft));
}

} // namespace

TEST(CastAnalysis, ACastOnAnObliquePlaneShowsNoSliversAtThePartingLine) {
    const auto cast = test::moved(test::frusta(20, 30, 8, 6, 0.1), Eigen::Vector3d(1, 2, 3).normalized(), 0.7,
                                  Eigen::Vector3d(5, -3, 11));
    const DraftAnalysis analysis = analysed(cast, 1);
    EXPECT_TRUE(analysis.castable());
    EXPECT_NEAR(analysis.worstDraftDegrees, degrees(std::atan(0.1)), 1e-4);
    EXPECT_EQ(analysis.energy, 0);
}

TEST(CastAnalysis, AStricterDraftFindsTheWalls) {
    const auto cast = test::frusta(20, 30, 8, 6, 0.1);
    const DraftAnalysis analysis = analysed(cast, 10);
    EXPECT_GT(analysis.violatingArea, 0);
    EXPECT_GT(analysis.energy, 0);
}

TEST(CastAnalysis, WithoutACertificateItFindsTheSame) {
    const auto cast = test::frusta(20, 30, 8, 6, 0.1);
    const SideLabels labels = labelSides(cast.mesh, cast.state.plane);
    for (const double draft : {1.0, 10.0}) {
        const DraftAnalysis quick = analyzeCast(cast.mesh, labels, cast.state, draft);
        const DraftAnalysis exact = analysed(cast, draft);
        EXPECT_EQ(quick.violating, exact.violating);
        EXPECT_EQ(quick.faceDraft, exact.faceDraft);
        EXPECT_EQ(quick.violatingArea, exact.violatingArea);
    }
}

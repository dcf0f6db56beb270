// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/certificate.h"

#include "support/casts.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector3d;

namespace {

Certificate proofOf(const KnownCast& cast, double draft = 1) {
    return certify(cast.mesh, labelSides(cast.mesh, cast.state.plane), cast.state, draft);
}

KnownCast shifted(KnownCast cast, double x) {
    cast.mesh.V.col(0).array() += x;
    return cast;
}

const double fiveDegrees = std::tan(radians(5));

} // namespace

TEST(Certificate, HoldsForCastableShapes) {
    const std::vector<KnownCast> casts = {frusta(20, 10, 5, 3, fiveDegrees), ball(10, 3), ring(10, 3, 40, 16),
                                          frusta(20, 10, 5, 0, fiveDegrees),
                                          sheared(frusta(20, 10, 5, 3, 0.2), 0.1, -0.15)};
    for (const KnownCast& cast : casts) {
        const Certificate proof = proofOf(cast);
        EXPECT_TRUE(proof.holds()) << proof.reason;
        EXPECT_EQ(proof.reason, "");
    }
}

TEST(Certificate, HoldsForFloatPointsOfAnObliquePlane) {
    for (double angle = 0.1; angle < 3; angle += 0.37) {
        const KnownCast cast =
            moved(sheared(ring(10, 3, 40, 16), 0.04, 0.03), {1, 2, 3}, angle, {100, -3, 7});
        const Certificate proof = proofOf(cast);
        EXPECT_TRUE(proof.holds()) << angle << ": " << proof.reason;
    }
}

TEST(Certificate, StatesTheWorstDraftRoundedDown) {
    const Certificate proof = proofOf(frusta(20, 10, 5, 3, fiveDegrees), 5 - 1e-5);
    EXPECT_TRUE(proof.holds()) << proof.reason;
    EXPECT_LE(proof.worstDraftDegrees, 5);
    EXPECT_GT(proof.worstDraftDegrees, 5 - 1e-5);
}

TEST(Certificate, ADraftThatIsJustMissedIsMissed) {
    // Walls leaning 3 : 4 have N·d = 3/5 exactly; the tolerance is a rational above sin(draft).
    const KnownCast cast = frusta(32, 24, 8, 4, 0.75);
    const double exactDraft = degrees(std::asin(0.6));
    EXPECT_FALSE(proofOf(cast, exactDraft).draftHolds);
    EXPECT_EQ(proofOf(cast, exactDraft).violatingFaces.size(), 16U);
    EXPECT_TRUE(proofOf(cast, exactDraft - 1e-12).draftHolds);
}

TEST(Certificate, VerticalWallsAreNotCastableButOneUlpOfLeanIs) {
    KnownCast cast = frusta(20, 10, 5, 3, 0);
    EXPECT_EQ(proofOf(cast, 0).violatingFaces.size(), 16U);
    for (int v = 0; v < cast.mesh.vertexCount(); ++v)
        for (int k = 0; k < 2 && cast.mesh.V(v, 2) != 0; ++k)
            cast.mesh.V(v, k) = std::nextafter(cast.mesh.V(v, k), 0.0);
    EXPECT_TRUE(proofOf(cast, 0).holds()) << proofOf(cast, 0).reason;
}

TEST(Certificate, AFaceAcrossThePlaneHasNoSide) {
    KnownCast cast = frusta(20, 10, 5, 3, fiveDegrees);
    cast.state.plane.offset = 1;
    const SideLabels labels = labelSides(cast.mesh, cast.state.plane);
    EXPECT_EQ(std::count(labels.begin(), labels.end(), 0), 8);
    EXPECT_FALSE(proofOf(cast).holds());
    EXPECT_FALSE(proofOf(cast).draftHolds);
}

TEST(Certificate, FacesInThePlaneBelongToTheSideTheyLookTo) {
    const KnownCast cast = frusta(20, 10, 5, 0, fiveDegrees);
    const SideLabels labels = labelSides(cast.mesh, cast.state.plane);
    EXPECT_EQ(std::count(labels.begin(), labels.end(), 2), 2);
    EXPECT_EQ(labels[0], 2);
}

TEST(Certificate, DirectionsMustLeaveThePlane) {
    KnownCast cast = frusta(20, 10, 5, 3, fiveDegrees);
    std::swap(cast.state.directions.d1, cast.state.directions.d2);
    EXPECT_FALSE(proofOf(cast).directionsLeave);
}

TEST(Certificate, ADimpleBelowThePlaneIsNotOfItsSide) {
    KnownCast cast = ball(10, 2);
    const SideLabels labels = labelSides(cast.mesh, cast.state.plane);
    for (int v = 0; v < cast.mesh.vertexCount(); ++v)
        if (cast.mesh.V(v, 2) > 9.9)
            cast.mesh.V(v, 2) = -1e-3;
    EXPECT_FALSE(certify(cast.mesh, labels, cast.state, 1).curvesOnPlane);
}

TEST(Certificate, CrossingPartingCurvesAreRefused) {
    const KnownCast one = frusta(20, 10, 5, 3, fiveDegrees);
    const IndexedMesh apart = together(one.mesh, shifted(one, 20.5).mesh);
    const IndexedMesh crossing = together(one.mesh, shifted(frusta(20, 8, 4, 2, fiveDegrees), 15).mesh);
    const IndexedMesh touching = together(one.mesh, shifted(one, 20).mesh);
    EXPECT_TRUE(proofOf({apart, one.state}).holds()) << proofOf({apart, one.state}).reason;
    EXPECT_FALSE(proofOf({crossing, one.state}).curvesSimpleAndNested);
    EXPECT_FALSE(proofOf({crossing, one.state}).selfIntersectionFree);
    EXPECT_FALSE(proofOf({touching, one.state}).curvesSimpleAndNested);
}

TEST(Certificate, ASolidInsideASolidIsNestedWrongly) {
    const KnownCast outer = frusta(20, 10, 5, 3, fiveDegrees);
    const Certificate proof =
        proofOf({together(outer.mesh, frusta(4, 3, 2, 1, fiveDegrees).mesh), outer.state});
    EXPECT_TRUE(proof.draftHolds);
    EXPECT_TRUE(proof.selfIntersectionFree);
    EXPECT_FALSE(proof.curvesSimpleAndNested);
}

TEST(Certificate, CurvesAreJudgedAlongBothDirections) {
    // Side by side in the plane, but leaning: what counts is the image along each direction.
    const KnownCast cast = sheared(frusta(20, 10, 5, 3, 0.3), 0.25, 0.1);
    EXPECT_TRUE(proofOf(cast).holds()) << proofOf(cast).reason;
    KnownCast upright = cast;
    upright.state.directions = Directions::normalTo(cast.state.plane);
    EXPECT_NEAR(proofOf(upright).worstDraftDegrees, degrees(std::atan(0.05)), 1e-4);
}

TEST(Certificate, AnOpenSurfaceIsNone) {
    KnownCast cast = ball(10, 2);
    cast.mesh.F.conservativeResize(cast.mesh.F.rows() - 1, 3);
    const Certificate proof = proofOf(cast);
    EXPECT_FALSE(proof.closedAndOutward);
    EXPECT_FALSE(proof.holds());
    EXPECT_NE(proof.reason, "");
}

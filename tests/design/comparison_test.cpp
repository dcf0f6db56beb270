// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/comparison.h"

#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace moldwright;

namespace {

std::vector<int> samePoints(const IndexedMesh& mesh) {
    std::vector<int> source(static_cast<std::size_t>(mesh.vertexCount()));
    std::iota(source.begin(), source.end(), 0);
    return source;
}

IndexedMesh moved(IndexedMesh mesh) {
    mesh = test::rotated(mesh, Eigen::Vector3d(1, 2, 3).normalized(), 0.7);
    mesh.V.rowwise() += Eigen::RowVector3d(10, -20, 30);
    return mesh;
}

/// A ball of radius 1 with a smooth horn along x; the horn's points beyond x = 0.9 reach `length` further.
IndexedMesh hornedBall(double length) {
    IndexedMesh ball = test::sphere({0, 0, 0}, 1, 5);
    for (int v = 0; v < ball.vertexCount(); ++v)
        if (const double x = ball.V(v, 0); x > 0.9)
            ball.V(v, 0) += length * std::pow((x - 0.9) / 0.1, 0.5);
    return ball;
}

} // namespace

TEST(RigidFit, FindsARotationAndAShift) {
    const IndexedMesh ball = hornedBall(1);
    const IndexedMesh there = moved(ball);
    const Eigen::Isometry3d fit = bestRigidFit(ball.V, there.V);
    EXPECT_NEAR(fit.linear().determinant(), 1, 1e-12);
    for (int v = 0; v < ball.vertexCount(); v += 17)
        EXPECT_LT((fit * ball.point(v) - there.point(v)).norm(), 1e-12);
}

TEST(RigidFit, NeverMirrors) {
    const IndexedMesh ball = hornedBall(1);
    IndexedMesh mirrored = ball;
    mirrored.V.col(2) *= -1;
    mirrored.V.col(1) += 0.3 * mirrored.V.col(0);
    EXPECT_NEAR(bestRigidFit(ball.V, mirrored.V).linear().determinant(), 1, 1e-12);
}

TEST(MeasureChange, IsNothingForTheSameShapeHoweverMoved) {
    const IndexedMesh part = hornedBall(1);
    for (const IndexedMesh& cast : {part, moved(part)}) {
        const Change change = measureChange(part, part, cast, samePoints(part));
        EXPECT_NEAR(change.meanDistance, 0, 1e-12);
        EXPECT_NEAR(change.maxDistance, 0, 1e-12);
        EXPECT_NEAR(change.volumeRatio, 1, 1e-12);
    }
}

TEST(MeasureChange, OfABallBlownUp) {
    const IndexedMesh part = test::sphere({5, 6, 7}, 10, 3);
    const IndexedMesh cast = test::sphere({5, 6, 7}, 11, 3);
    const Change change = measureChange(part, part, cast, samePoints(part));
    EXPECT_NEAR(change.meanDistance, 1 / diagonal(part), 0.02 / diagonal(part));
    EXPECT_NEAR(change.maxDistance, 1 / diagonal(part), 0.02 / diagonal(part));
    EXPECT_NEAR(change.volumeRatio, 1.331, 1e-9);
}

TEST(MeasureLimbs, OfTheSameShapeMovedAreWhole) {
    const IndexedMesh part = hornedBall(1.5);
    const auto limbs = measureLimbs(part, moved(part), samePoints(part), {{3, 0, 0}});
    ASSERT_EQ(limbs.size(), 1U);
    EXPECT_LT((limbs[0].tip - Eigen::Vector3d(2.5, 0, 0)).norm(), 1e-9);
    EXPECT_NEAR(limbs[0].lengthRatio, 1, 1e-9);
    EXPECT_NEAR(limbs[0].volumeRatio, 1, 1e-9);
}

TEST(MeasureLimbs, FindAStretchedHornByThemselves) {
    const IndexedMesh part = hornedBall(1.5);
    IndexedMesh cast = part;
    for (int v = 0; v < cast.vertexCount(); ++v)
        if (double& x = cast.V(v, 0); x > 0.9)
            x = 0.9 + 1.4 * (x - 0.9);
    const auto limbs = measureLimbs(part, cast, samePoints(part), {});
    const auto horn = std::ranges::find_if(
        limbs, [](const LimbMeasure& limb) { return (limb.tip - Eigen::Vector3d(2.5, 0, 0)).norm() < 1e-9; });
    ASSERT_NE(horn, limbs.end());
    // Somewhat less than the horn's own 1.4: the limb ends on the ball, which stays.
    EXPECT_GT(horn->lengthRatio, 1.25);
    EXPECT_LT(horn->lengthRatio, 1.4);
    EXPECT_GT(horn->volumeRatio, 1.2);
    EXPECT_LT(horn->volumeRatio, 1.4);
}

TEST(Deviation, IsTheWayToTheOtherSurfaceAfterTheBestFit) {
    const IndexedMesh part = test::sphere({0, 0, 0}, 10, 4);
    IndexedMesh larger = part;
    larger.V *= 1.1;
    const Deviation there = deviation(part, moved(larger), part.V);
    ASSERT_EQ(there.ofCast.size(), static_cast<std::size_t>(part.faceCount()));
    ASSERT_EQ(there.ofPart.size(), static_cast<std::size_t>(part.faceCount()));
    for (const std::vector<double>& side : {there.ofCast, there.ofPart}) {
        EXPECT_NEAR(*std::ranges::min_element(side), 1, 0.02);
        EXPECT_NEAR(*std::ranges::max_element(side), 1, 0.02);
    }
    const Deviation none = deviation(part, moved(part), part.V);
    EXPECT_NEAR(*std::ranges::max_element(none.ofCast), 0, 1e-9);
}

TEST(Deviation, SitsWhereTheShapeWasChanged) {
    const IndexedMesh part = hornedBall(0.5);
    const IndexedMesh cast = hornedBall(1.5);
    const std::vector<double> ofCast = deviation(part, cast, part.V).ofCast;
    const auto largest = static_cast<int>(std::ranges::max_element(ofCast) - ofCast.begin());
    EXPECT_GT(cast.corner(largest, 0).x(), 2);
    EXPECT_NEAR(ofCast[static_cast<std::size_t>(largest)], 1, 0.15);
}

TEST(RmsDistance, IsTheRadiusGainedOfABallBlownUp) {
    const IndexedMesh part = test::sphere({5, 6, 7}, 10, 4);
    const IndexedMesh cast = test::sphere({5, 6, 7}, 11, 4);
    EXPECT_NEAR(rmsDistance(part, moved(cast), part.V), 1, 0.02);
    EXPECT_NEAR(rmsDistance(part, moved(part), part.V), 0, 1e-6);
}

TEST(CastDifference, IsNothingBetweenCastsThatDifferByTheirPlace) {
    const IndexedMesh part = hornedBall(1);
    for (const double d : castDifference(part, part.V, moved(part), part.V))
        ASSERT_NEAR(d, 0, 1e-6);
}

TEST(CastDifference, IsTheWayBetweenBothEachLaidOverItsPart) {
    const IndexedMesh part = test::sphere({0, 0, 0}, 10, 4);
    IndexedMesh larger = part;
    larger.V *= 1.2;
    const std::vector<double> there = castDifference(moved(larger), part.V, part, part.V);
    const std::vector<double> back = castDifference(part, part.V, moved(larger), part.V);
    ASSERT_EQ(there.size(), static_cast<std::size_t>(part.faceCount()));
    for (const std::vector<double>& side : {there, back}) {
        EXPECT_NEAR(*std::ranges::min_element(side), 2, 0.03);
        EXPECT_NEAR(*std::ranges::max_element(side), 2, 0.03);
    }
    // Where a file does not tell how points lay in the part, they lie as they are.
    const std::vector<double> plain = castDifference(larger, {}, part, {});
    EXPECT_NEAR(*std::ranges::max_element(plain), 2, 0.03);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/directions.h"

#include "base/parallel.h"
#include "base/vector_code.h"
#include "castability/energy.h"
#include "support/finite_differences.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

const PartingPlane plane{Eigen::Vector3d(0.2, -0.3, 1).normalized(), 0.07};
const double tau = std::sin(radians(3));

IndexedMesh egg() {
    return test::sphere({0.1, -0.05, 0.02}, 0.5, 4);
}

/// A box sheared by 20°: only along its slanted edges do both halves come off without undercut.
IndexedMesh leaningPrism() {
    IndexedMesh prism = test::splitInFour(test::box({-1, -1, -1}, {1, 1, 1}));
    prism.V.col(0) += std::tan(radians(20)) * prism.V.col(2);
    return prism;
}

} // namespace

TEST(SideFaces, BothSidesTogetherHaveTheWholeEnergy) {
    const PartedFaces parted = partFaces(egg(), plane);
    const Directions directions{Eigen::Vector3d(0.3, 0.1, 1).normalized(),
                                Eigen::Vector3d(0.1, 0.4, -1).normalized()};
    const double sum =
        parted.side1.energy(directions.d1, tau).value + parted.side2.energy(directions.d2, tau).value;
    EXPECT_NEAR(sum, castabilityEnergy(egg(), {plane, directions}, tau), 1e-14);
}

TEST(SideFaces, GradientAndHessianMatchFiniteDifferences) {
    const PartedFaces parted = partFaces(egg(), plane);
    const Eigen::Vector3d d = Eigen::Vector3d(0.3, 0.1, 1).normalized();
    const SideFaces::Energy e = parted.side1.energy(d, tau);
    const auto value = [&](const Eigen::VectorXd& x) { return parted.side1.energy(x, tau).value; };
    EXPECT_LT(test::relativeError(e.gradient, test::finiteDifferences(value, d)), 1e-6);
    for (int k = 0; k < 3; ++k) {
        const auto slope = [&](const Eigen::VectorXd& x) { return parted.side1.energy(x, tau).gradient[k]; };
        EXPECT_LT(test::relativeError(e.hessian.col(k), test::finiteDifferences(slope, d)), 1e-5) << k;
    }
}

TEST(SideFaces, SameBitsForAnyVectorWidth) {
    const Eigen::Vector3d d = plane.normal;
    const auto energy = [&] { return partFaces(egg(), plane).side2.energy(-d, tau).value; };
    const double widest = energy();
    limitVectorCode(VectorCode::Plain);
    EXPECT_EQ(energy(), widest);
    limitVectorCode(VectorCode::Avx2);
    EXPECT_EQ(energy(), widest);
    limitVectorCode(VectorCode::Avx512);
}

TEST(Directions, ALeaningPrismOpensAlongItsAxis) {
    const Directions best = bestDirections(leaningPrism(), PartingPlane{}, 0, {30});
    const Eigen::Vector3d axis(std::sin(radians(20)), 0, std::cos(radians(20)));
    EXPECT_LT(degrees(std::acos(best.d1.dot(axis))), 0.5);
    EXPECT_LT(degrees(std::acos(-best.d2.dot(axis))), 0.5);
}

TEST(Directions, NoneLeansFurtherThanTheCap) {
    const Directions capped = bestDirections(leaningPrism(), PartingPlane{}, 0, {10});
    EXPECT_NEAR(degrees(std::acos(capped.d1.z())), 10, 1e-6);
    EXPECT_NEAR(degrees(std::acos(-capped.d2.z())), 10, 1e-6);
    const Directions upright = bestDirections(leaningPrism(), PartingPlane{}, 0, {0});
    EXPECT_EQ(upright, Directions::normalTo(PartingPlane{}));
}

TEST(Directions, NoDirectionNearbyIsBetter) {
    const IndexedMesh shape = test::rotated(test::torus(2, 0.6, 40, 20), {0.6, 0.8, 0}, 0.4);
    const Directions best = bestDirections(shape, plane, 3, {30});
    const PartedFaces parted = partFaces(shape, plane);
    const double least = parted.side1.energy(best.d1, tau).value;
    const auto [x, y] = planeAxes(best.d1);
    for (const double angle : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) {
        const Eigen::Vector3d aside =
            (best.d1 + 0.01 * (std::cos(angle) * x + std::sin(angle) * y)).normalized();
        EXPECT_GE(parted.side1.energy(aside, tau).value, least);
    }
}

TEST(Directions, SameAnswerForAnyNumberOfThreads) {
    setThreadCount(1);
    const Directions one = bestDirections(egg(), plane, 3, {30});
    setThreadCount(3);
    EXPECT_EQ(bestDirections(egg(), plane, 3, {30}), one);
    setThreadCount(0);
}

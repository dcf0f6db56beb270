// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/energy.h"

#include "base/parallel.h"
#include "mesh/measures.h"
#include "support/finite_differences.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <random>

using namespace moldwright;

namespace {

/// A bumpy closed shape that crosses the plane of tiltedState() in many faces.
IndexedMesh bumpySphere() {
    IndexedMesh mesh = test::sphere({0.1, -0.05, 0.02}, 0.5, 3);
    std::mt19937 random(7);
    for (Eigen::Index i = 0; i < mesh.V.size(); ++i)
        mesh.V.data()[i] += 0.03 * (static_cast<double>(random()) / 4294967296.0 - 0.5);
    return mesh;
}

MoldState tiltedState() {
    MoldState state;
    state.plane = {Eigen::Vector3d(0.2, -0.3, 1).normalized(), 0.07};
    state.directions = {Eigen::Vector3d(0.3, 0.1, 1).normalized(),
                        Eigen::Vector3d(0.1, 0.4, -1).normalized()};
    return state;
}

const double tau = std::sin(radians(3));

} // namespace

TEST(CastabilityEnergy, OneFaceHasItsHandCalculatedValue) {
    // A square of area 1 below the plane, looking along +x: N·d2 = sin 10° against τ = sin 20°.
    IndexedMesh square;
    square.V.resize(4, 3);
    square.V << 0, 0, -2, 0, 1, -2, 0, 1, -1, 0, 0, -1;
    square.F.resize(2, 3);
    square.F << 0, 1, 2, 0, 2, 3;
    MoldState state;
    state.directions.d2 = {std::sin(radians(10)), 0, -std::cos(radians(10))};
    const double h = std::sin(radians(10)) - std::sin(radians(20));
    EXPECT_NEAR(castabilityEnergy(square, state, std::sin(radians(20))), 0.5 * h * h, 1e-15);
    EXPECT_EQ(castabilityEnergy(square, state, std::sin(radians(9))), 0);
}

TEST(CastabilityEnergy, AFaceAcrossThePlaneCountsAsTwoPieces) {
    // The same square, three quarters of it above the plane: each share meets its own direction.
    IndexedMesh square;
    square.V.resize(4, 3);
    square.V << 0, 0, -0.25, 0, 1, -0.25, 0, 1, 0.75, 0, 0, 0.75;
    square.F.resize(2, 3);
    square.F << 0, 1, 2, 0, 2, 3;
    const MoldState state; // N·d1 = N·d2 = 0
    EXPECT_NEAR(castabilityEnergy(square, state, 0.1), 0.5 * 0.01, 1e-15);
    MoldState leaning = state;
    leaning.directions.d1 = {0.6, 0, 0.8};
    EXPECT_NEAR(castabilityEnergy(square, leaning, 0.1), 0.5 * 0.01 * 0.25, 1e-15);
}

TEST(CastabilityEnergy, ABoxOpensAlongItsAxisWithoutDraftOnly) {
    const IndexedMesh box = test::box({-1, -1, -1}, {1, 1, 1});
    EXPECT_EQ(castabilityEnergy(box, MoldState{}, 0), 0);
    EXPECT_NEAR(castabilityEnergy(box, MoldState{}, 0.1), 0.5 * 0.01 * 16, 1e-12);
}

TEST(CastabilityEnergy, AFaceInThePlaneBelongsToTheHalfThatFormsIt) {
    const IndexedMesh onTable = test::box({-1, -1, 0}, {1, 1, 2});
    EXPECT_EQ(castabilityEnergy(onTable, MoldState{}, 0), 0);
}

TEST(CastabilityEnergy, VertexGradientMatchesFiniteDifferences) {
    IndexedMesh mesh = bumpySphere();
    const MoldState state = tiltedState();
    Points gradient;
    castabilityEnergy(mesh, state, tau, gradient);
    const auto at = [&](const Eigen::VectorXd& x) {
        IndexedMesh moved = mesh;
        moved.V = Eigen::Map<const Points>(x.data(), mesh.V.rows(), 3);
        return castabilityEnergy(moved, state, tau);
    };
    const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(mesh.V.data(), mesh.V.size());
    const Eigen::VectorXd analytic = Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size());
    EXPECT_LT(test::relativeError(analytic, test::finiteDifferences(at, x)), 1e-6);
}

TEST(CastabilityEnergy, StateGradientMatchesFiniteDifferences) {
    const IndexedMesh mesh = bumpySphere();
    const MoldState state = tiltedState();
    StateGradient gradient;
    castabilityEnergy(mesh, state, tau, gradient);
    const auto at = [&](const Eigen::VectorXd& x) {
        return castabilityEnergy(mesh, MoldState{{x.segment<3>(0), x[3]}, {x.segment<3>(4), x.segment<3>(7)}},
                                 tau);
    };
    Eigen::VectorXd x(10);
    x << state.plane.normal, state.plane.offset, state.directions.d1, state.directions.d2;
    Eigen::VectorXd analytic(10);
    analytic << gradient.normal, gradient.offset, gradient.d1, gradient.d2;
    EXPECT_LT(test::relativeError(analytic, test::finiteDifferences(at, x)), 1e-6);
}

TEST(CastabilityEnergy, SameBitsForAnyNumberOfThreads) {
    const IndexedMesh mesh = test::splitInFour(test::splitInFour(bumpySphere()));
    setThreadCount(1);
    const double one = castabilityEnergy(mesh, tiltedState(), tau);
    setThreadCount(4);
    EXPECT_EQ(castabilityEnergy(mesh, tiltedState(), tau), one);
    setThreadCount(0);
}

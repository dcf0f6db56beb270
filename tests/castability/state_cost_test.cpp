// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/state_cost.h"

#include "base/parallel.h"
#include "base/vector_code.h"
#include "castability/analysis.h"
#include "castability/state_coordinates.h"
#include "mesh/measures.h"
#include "support/finite_differences.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

const double tau = std::sin(radians(3));

IndexedMesh shape() {
    return test::rotated(test::torus(2, 0.6, 40, 20), {0.6, 0.8, 0}, 0.4);
}

MoldState tiltedState() {
    MoldState state;
    state.plane = {Eigen::Vector3d(0.3, -0.2, 0.9).normalized(), 0.25};
    state.directions = {Eigen::Vector3d(0.3, 0.1, 1).normalized(),
                        Eigen::Vector3d(0.1, 0.4, -1).normalized()};
    return state;
}

double volumeAbove(const IndexedMesh& mesh, const PartingPlane& plane) {
    return stateCost(FaceArrays(mesh), {plane, Directions::normalTo(plane)}, 0).volumeAbove;
}

} // namespace

TEST(StateCost, AgreesWithThePlainEnergyAndTheAnalysis) {
    const StateCost cost = stateCost(FaceArrays(shape()), tiltedState(), tau);
    const DraftAnalysis analysis = analyzeDraft(shape(), tiltedState(), 3, false);
    EXPECT_NEAR(cost.energy, castabilityEnergy(shape(), tiltedState(), tau), 1e-12 * cost.energy);
    EXPECT_NEAR(cost.violatingArea, analysis.violatingArea, 1e-12 * cost.violatingArea);
    EXPECT_NEAR(draftDegrees(cost.worstSine), analysis.worstDraftDegrees, 1e-9);
}

TEST(StateCost, GradientsAreThoseOfThePlainEnergy) {
    StateGradient plain;
    (void)castabilityEnergy(shape(), tiltedState(), tau, plain);
    StateGradient energy;
    VolumeGradient volume;
    const StateCost cost = stateCost(FaceArrays(shape()), tiltedState(), tau, energy, volume);
    EXPECT_EQ(cost.energy, stateCost(FaceArrays(shape()), tiltedState(), tau).energy);
    EXPECT_TRUE(energy.normal.isApprox(plain.normal, 1e-12));
    EXPECT_NEAR(energy.offset, plain.offset, 1e-12 * std::abs(plain.offset));
    EXPECT_TRUE(energy.d1.isApprox(plain.d1, 1e-12));
    EXPECT_TRUE(energy.d2.isApprox(plain.d2, 1e-12));
}

TEST(StateCost, VolumeAboveOfABoxIsItsShare) {
    const IndexedMesh box = test::box({0, 0, 0}, {2, 3, 4});
    EXPECT_NEAR(volumeAbove(box, {Eigen::Vector3d::UnitZ(), 1}), 18, 1e-12);
    EXPECT_NEAR(volumeAbove(box, {-Eigen::Vector3d::UnitZ(), -1}), 6, 1e-12);
    EXPECT_NEAR(volumeAbove(box, {Eigen::Vector3d(1, 1, 1).normalized(), 100}), 0, 1e-12);
    EXPECT_NEAR(volumeAbove(box, {Eigen::Vector3d(1, 1, 1).normalized(), -100}), volume(box), 1e-11);
}

TEST(StateCost, VolumeGradientMatchesFiniteDifferences) {
    const PartingPlane plane = tiltedState().plane;
    StateGradient energy;
    VolumeGradient gradient;
    (void)stateCost(FaceArrays(shape()), tiltedState(), tau, energy, gradient);
    Eigen::VectorXd x(4);
    x << plane.normal, plane.offset;
    Eigen::VectorXd analytic(4);
    analytic << gradient.normal, gradient.offset;
    // The normal leaves the unit sphere here, and with it the length of distances: compare along the tangent.
    const auto at = [&](const Eigen::VectorXd& y) {
        const double length = y.head<3>().norm();
        return volumeAbove(shape(), {y.head<3>() / length, y[3] / length});
    };
    EXPECT_LT(test::relativeError(analytic, test::finiteDifferences(at, x)), 1e-4);
}

TEST(StateCost, ManyStatesCostWhatEachCostsAlone) {
    const FaceArrays faces(test::splitInFour(shape()));
    std::vector<MoldState> states(40, tiltedState());
    for (std::size_t i = 0; i < states.size(); ++i)
        states[i].plane.offset = 0.05 * static_cast<double>(i) - 1;
    const std::vector<StateCost> costs = stateCosts(faces, states, tau);
    for (std::size_t i = 0; i < states.size(); ++i) {
        const StateCost alone = stateCost(faces, states[i], tau);
        EXPECT_EQ(costs[i].energy, alone.energy);
        EXPECT_EQ(costs[i].volumeAbove, alone.volumeAbove);
    }
}

TEST(StateCost, SameBitsForAnyVectorWidthAndNumberOfThreads) {
    const FaceArrays faces(test::splitInFour(shape()));
    const StateCost widest = stateCost(faces, tiltedState(), tau);
    for (const VectorCode code : {VectorCode::Plain, VectorCode::Avx2, VectorCode::Avx512}) {
        limitVectorCode(code);
        setThreadCount(static_cast<int>(code) + 1);
        const StateCost cost = stateCost(FaceArrays(test::splitInFour(shape())), tiltedState(), tau);
        EXPECT_EQ(cost.energy, widest.energy);
        EXPECT_EQ(cost.volumeAbove, widest.volumeAbove);
        EXPECT_EQ(cost.violatingArea, widest.violatingArea);
        EXPECT_EQ(cost.worstSine, widest.worstSine);
    }
    setThreadCount(0);
}

TEST(StateCoordinates, GiveBackTheirStartWithinTheCap) {
    const StateCoordinates coordinates(tiltedState(), 45, DirectionsFollow::Freely);
    const MoldState back = coordinates.state(coordinates.origin());
    EXPECT_TRUE(back.plane.normal.isApprox(tiltedState().plane.normal, 1e-12));
    EXPECT_TRUE(back.directions.d1.isApprox(tiltedState().directions.d1, 1e-9));
    EXPECT_TRUE(back.directions.d2.isApprox(tiltedState().directions.d2, 1e-9));
    const StateCoordinates narrow(tiltedState(), 5, DirectionsFollow::Freely);
    const MoldState capped = narrow.state(narrow.origin());
    EXPECT_GT(capped.directions.d1.dot(capped.plane.normal), std::cos(radians(5)));
}

TEST(StateCoordinates, PulledBackGradientMatchesFiniteDifferences) {
    const FaceArrays faces(shape());
    for (const auto follow : {DirectionsFollow::Freely, DirectionsFollow::Normal, DirectionsFollow::Held}) {
        const StateCoordinates coordinates(tiltedState(), 30, follow);
        Eigen::VectorXd x = coordinates.origin();
        for (Eigen::Index i = 0; i < x.size(); ++i)
            x[i] += 0.1 - 0.03 * static_cast<double>(i);
        StateGradient g;
        VolumeGradient v;
        (void)stateCost(faces, coordinates.state(x), tau, g, v);
        Eigen::VectorXd gradient;
        coordinates.pullBack(x, g, gradient);
        const auto at = [&](const Eigen::VectorXd& y) {
            return stateCost(faces, coordinates.state(y), tau).energy;
        };
        EXPECT_LT(test::relativeError(gradient, test::finiteDifferences(at, x)), 1e-6)
            << static_cast<int>(follow);
    }
}

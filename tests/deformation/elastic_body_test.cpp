// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/elastic_body.h"

#include "base/parallel.h"
#include "base/vector_code.h"
#include "support/finite_differences.h"
#include "support/shapes.h"
#include "support/solids.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace moldwright;

namespace {

Positions unflattened(const Eigen::VectorXd& x) {
    return Eigen::Map<const Positions>(x.data(), x.size() / 3, 3);
}

Eigen::VectorXd flattened(const Positions& X) {
    return Eigen::Map<const Eigen::VectorXd>(X.data(), X.size());
}

BodyShape boxBody(double membrane, double volumeStiffness) {
    const test::Solid solid = test::solidBox({0, 0, 0}, {1.5, 1, 0.8}, {3, 2, 2});
    BodyShape shape{solid.tets.V, solid.tets.T, solid.F, {}, membrane, volumeStiffness};
    for (Eigen::Index t = 0; t < shape.T.rows(); ++t)
        shape.tetWeights.push_back(1 + 0.1 * static_cast<double>(t % 7));
    return shape;
}

BodyShape shellBody() {
    const IndexedMesh ball = test::sphere({0, 0, 0}, 1, 1);
    return {ball.V, {}, ball.F, {}, 2, 0};
}

/// Bent, twisted and shaken: nothing of the rest shape is left undisturbed.
Positions disturbed(const Points& V) {
    Positions X = V;
    for (Eigen::Index v = 0; v < X.rows(); ++v) {
        const Eigen::Vector3d x = V.row(v).transpose();
        X.row(v) = (Eigen::AngleAxisd(1.1 * x.x(), Eigen::Vector3d(1, 2, -1).normalized()) * x).transpose() +
                   0.05 * Eigen::RowVector3d(std::sin(7.0 * static_cast<double>(v)),
                                             std::cos(5.0 * static_cast<double>(v)),
                                             std::sin(3.0 * static_cast<double>(v) + 1));
    }
    return X;
}

double energyAt(const ElasticBody& body, const Positions& X) {
    Positions gradient = Positions::Zero(X.rows(), 3);
    return body.energy(X, 1, gradient);
}

/// Every third tetrahedron and face is more important.
BodyShape weighed(BodyShape shape) {
    for (Eigen::Index t = 0; t < shape.T.rows(); ++t)
        shape.tetWeights.push_back(t % 3 == 0 ? 16 : 1);
    for (Eigen::Index f = 0; f < shape.F.rows(); ++f)
        shape.faceWeights.push_back(f % 3 == 0 ? 16 : 1);
    return shape;
}

struct NamedBody {
    const char* name;
    BodyShape shape;
};

std::ostream& operator<<(std::ostream& out, const NamedBody& body) {
    return out << body.name;
}

class EveryBody : public testing::TestWithParam<NamedBody> {};

} // namespace

TEST_P(EveryBody, HasNoEnergyAtRestNorMovedRigidly) {
    const ElasticBody body(GetParam().shape);
    const Eigen::Isometry3d motion =
        Eigen::Translation3d(3, -4, 5) * Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, -2, 2).normalized());
    const Positions moved =
        (GetParam().shape.V * motion.linear().transpose()).rowwise() + motion.translation().transpose();
    for (const Positions& X : {Positions(GetParam().shape.V), moved}) {
        Positions gradient = Positions::Zero(X.rows(), 3);
        EXPECT_NEAR(body.energy(X, 1, gradient), 0, 1e-14);
        EXPECT_LT(gradient.norm(), 1e-12);
    }
}

TEST_P(EveryBody, GradientAgreesWithFiniteDifferences) {
    const ElasticBody body(GetParam().shape);
    const Positions X = disturbed(GetParam().shape.V);
    Positions gradient = Positions::Zero(X.rows(), 3);
    EXPECT_GT(body.energy(X, 1, gradient), 0.01);
    const Eigen::VectorXd numeric = test::finiteDifferences(
        [&](const Eigen::VectorXd& x) { return energyAt(body, unflattened(x)); }, flattened(X));
    EXPECT_LT(test::relativeError(flattened(gradient), numeric), 1e-7);
}

TEST_P(EveryBody, AddsItsGradientTimesTheWeight) {
    const ElasticBody body(GetParam().shape);
    const Positions X = disturbed(GetParam().shape.V);
    Positions once = Positions::Zero(X.rows(), 3);
    Positions onTop = Positions::Ones(X.rows(), 3);
    EXPECT_EQ(body.energy(X, 1, once), body.energy(X, -3, onTop));
    EXPECT_LT((onTop - (Positions::Ones(X.rows(), 3) - 3 * once)).norm(), 1e-12);
}

TEST_P(EveryBody, GivesTheSameBitsForAnyNumberOfThreads) {
    const ElasticBody body(GetParam().shape);
    const Positions X = disturbed(GetParam().shape.V);
    std::vector<std::pair<double, Positions>> results;
    for (const int threads : {1, 2, 4}) {
        setThreadCount(threads);
        Positions gradient = Positions::Zero(X.rows(), 3);
        const double energy = body.energy(X, 0.7, gradient);
        results.emplace_back(energy, gradient);
    }
    setThreadCount(0);
    EXPECT_EQ(results[0], results[1]);
    EXPECT_EQ(results[0], results[2]);
}

TEST_P(EveryBody, AtFixedRotationsTheGradientIsTwiceLaplacianLessRightHandSide) {
    BodyShape shape = GetParam().shape;
    shape.volumeStiffness = 0;
    const ElasticBody body(shape);
    const Positions X = disturbed(shape.V);
    Rotations R;
    body.fit(X, R);
    Positions gradient = Positions::Zero(X.rows(), 3);
    (void)body.energy(X, 1, gradient);
    // The rotations are optimal, so that they may be held while differentiating.
    const Positions byParts =
        2 * (body.laplacian().selfadjointView<Eigen::Lower>() * X - body.rightHandSide(R));
    EXPECT_LT((byParts - gradient).norm(), 1e-12 * gradient.norm() + 1e-13);
}

TEST_P(EveryBody, SameBitsForAnyVectorWidth) {
    const BodyShape shape = GetParam().shape;
    const ElasticBody body(shape);
    const Positions X = disturbed(shape.V);
    const auto evaluate = [&] {
        Positions gradient = Positions::Zero(X.rows(), 3);
        const double energy = body.energy(X, 1, gradient);
        return std::pair(energy, gradient);
    };
    const auto widest = evaluate();
    for (const VectorCode code : {VectorCode::Plain, VectorCode::Avx2, VectorCode::Avx512}) {
        limitVectorCode(code);
        EXPECT_EQ(evaluate(), widest);
    }
}

TEST_P(EveryBody, ANewRestShapeIsThatOfANewBody) {
    BodyShape shape = GetParam().shape;
    ElasticBody body(shape);
    shape.V = disturbed(shape.V);
    for (double& weight : shape.tetWeights)
        weight *= 1.5;
    body.setRest(shape.V, shape.tetWeights);
    const ElasticBody fresh(shape);
    const Positions X = 1.1 * shape.V;
    EXPECT_NEAR(energyAt(body, X), energyAt(fresh, X), 1e-12 * energyAt(fresh, X));
    EXPECT_TRUE(body.laplacian().isApprox(fresh.laplacian(), 1e-12));
}

INSTANTIATE_TEST_SUITE_P(Bodies, EveryBody,
                         testing::Values(NamedBody{"tets", boxBody(0, 0)}, NamedBody{"skin", boxBody(0.6, 0)},
                                         NamedBody{"weighed", weighed(boxBody(0.6, 5))},
                                         NamedBody{"volume", boxBody(0.6, 5)},
                                         NamedBody{"shell", shellBody()}));

TEST(ElasticBody, AnImportantFaceCountsForMore) {
    BodyShape shape = shellBody();
    const Positions X = 1.1 * shape.V;
    const double plain = energyAt(ElasticBody(shape), X);
    shape.faceWeights.assign(static_cast<std::size_t>(shape.F.rows()), 1);
    EXPECT_EQ(energyAt(ElasticBody(shape), X), plain);
    shape.faceWeights.assign(static_cast<std::size_t>(shape.F.rows()), 16);
    EXPECT_NEAR(energyAt(ElasticBody(shape), X), 16 * plain, 1e-12 * plain);
}

TEST(ElasticBody, CountsChangeOfVolumeOfASingleTet) {
    BodyShape shape;
    shape.V.resize(4, 3);
    shape.V << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    shape.T.resize(1, 4);
    shape.T << 0, 1, 2, 3;
    shape.volumeStiffness = 5;
    const double s = 1.2;
    const double cubeLess = s * s * s - 1;
    const double expected = (3 * (s - 1) * (s - 1) + 5 * cubeLess * cubeLess) / 6;
    EXPECT_NEAR(energyAt(ElasticBody(shape), s * shape.V), expected, 1e-14);
}

TEST(ElasticBody, AMembraneDoesNotMindItsFaceLeavingThePlane) {
    BodyShape shape;
    shape.V.resize(3, 3);
    shape.V << 0, 0, 0, 1, 0, 0, 0, 1, 0;
    shape.F.resize(1, 3);
    shape.F << 0, 1, 2;
    shape.membrane = 4;
    const ElasticBody body(shape);
    Positions X(3, 3);
    X << 0, 0, 0, 0, 0, 1.5, 0, 1, 0; // turned by a quarter, one edge half as long again
    EXPECT_NEAR(energyAt(body, X), 4 * 0.5 * 0.25, 1e-14);
}

TEST(SurfaceLaplacian, HasCotangentsOffTheDiagonalAndSumsToZero) {
    const IndexedMesh ball = test::sphere({0, 0, 0}, 1, 0); // equilateral faces
    const Eigen::SparseMatrix<double> whole =
        surfaceLaplacian(ball.V, ball.F).selfadjointView<Eigen::Lower>();
    const Eigen::MatrixXd A = whole;
    EXPECT_NEAR(A(0, 2), -1 / std::sqrt(3.0), 1e-12); // ½ (cot 60° + cot 60°)
    EXPECT_NEAR(A(0, 1), 0, 1e-12);                   // opposite points share no edge
    EXPECT_LT(A.rowwise().sum().norm(), 1e-12);
}

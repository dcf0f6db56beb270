// SPDX-License-Identifier: AGPL-3.0-or-later
// What the deformation repeats: the local-global iteration beside what memory allows, factorisation and
// rotation fit beside Eigen's.
#include "benchmarks/subjects.h"
#include "benchmarks/timing.h"

#include "base/parallel.h"
#include "deformation/local_global.h"
#include "deformation/rotation_fit.h"
#include "deformation/sparse_solver.h"

#include <Eigen/CholmodSupport>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <Eigen/SparseCholesky>

#include <cmath>
#include <random>

using namespace moldwright;
using namespace moldwright::bench;

namespace {

/// An element at rest: four corners, nine gradients, a weight.
constexpr double kElementBytes = 4 * sizeof(int) + 10 * sizeof(double);

/// Reads all numbers once, on all threads.
double readThrough(const Eigen::VectorXd& numbers) {
    constexpr std::size_t grain = 1 << 16;
    return parallelSum<double>(
        static_cast<std::size_t>(numbers.size()), grain, 0.0, [&](std::size_t begin, std::size_t end) {
            return numbers.segment(static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end - begin))
                .sum();
        });
}

Eigen::VectorXd numbersOf(double bytes) {
    return Eigen::VectorXd::Constant(static_cast<Eigen::Index>(bytes / sizeof(double)), 0.5);
}

/// The system matrix of a body's global step, a little shifted: positive definite.
Eigen::SparseMatrix<double> systemOf(const BodyShape& body) {
    Eigen::SparseMatrix<double> A = ElasticBody(body).laplacian();
    const double shift = 1e-7 * A.diagonal().mean();
    A.diagonal().array() += shift;
    return A;
}

/// A tetrahedron of the plain way.
struct PlainTet {
    Eigen::RowVector4i corners;
    Eigen::Matrix<double, 4, 3> gradients;
    double volume;
};

std::vector<PlainTet> plainTets(const BodyShape& body) {
    std::vector<PlainTet> tets;
    for (Eigen::Index t = 0; t < body.T.rows(); ++t) {
        PlainTet tet{body.T.row(t), {}, 0};
        Eigen::Matrix3d edges;
        for (int k = 0; k < 3; ++k)
            edges.row(k) = body.V.row(tet.corners[k + 1]) - body.V.row(tet.corners[0]);
        tet.gradients.bottomRows<3>() = edges.inverse().transpose();
        tet.gradients.row(0) = -tet.gradients.bottomRows<3>().colwise().sum();
        tet.volume = std::abs(edges.determinant()) / 6;
        tets.push_back(tet);
    }
    return tets;
}

Positions plainRightHandSide(const std::vector<PlainTet>& tets, const Positions& X) {
    Positions rhs = Positions::Zero(X.rows(), 3);
    for (const PlainTet& tet : tets) {
        Eigen::Matrix3d F = Eigen::Matrix3d::Zero();
        for (int k = 0; k < 4; ++k)
            F += X.row(tet.corners[k]).transpose() * tet.gradients.row(k);
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
        const Eigen::Matrix3d R = svd.matrixU() * svd.matrixV().transpose();
        for (int k = 0; k < 4; ++k)
            rhs.row(tet.corners[k]) += tet.volume * (R * tet.gradients.row(k).transpose()).transpose();
    }
    return rhs;
}

} // namespace

/// The bound: the factors read twice (forward and backward) and the elements once, from memory.
static void localGlobalIteration(benchmark::State& state) {
    const Subject& subject = subjectOf(state);
    const auto points = static_cast<std::size_t>(subject.body.V.rows());
    LocalGlobal solver(subject.body, std::vector<char>(points, 0), 0.1);
    const SideLabels sides = sidesOf(subject.body);
    const Directions directions = subject.frame.directionsToWork(subject.state.directions);
    const double tau = std::sin(radians(1));
    const Eigen::VectorXd factors = numbersOf(solver.system().factorBytes());
    const Eigen::VectorXd elements = numbersOf(kElementBytes * static_cast<double>(subject.body.T.rows()));
    Contest contest(state);
    for (auto _ : state)
        contest.round([&] { benchmark::DoNotOptimize(solver.iterate(sides, directions, tau)); },
                      [&] {
                          benchmark::DoNotOptimize(readThrough(factors));
                          benchmark::DoNotOptimize(readThrough(factors));
                          benchmark::DoNotOptimize(readThrough(elements));
                      });
    contest.conclude("bound", "ms", 1e3);
    state.counters["factor_MB"] = solver.system().factorBytes() / 1e6;
}
BENCHMARK(localGlobalIteration)->Apply(eachSubject);

/// The same step as one would write it first: a singular value decomposition for each tetrahedron, Eigen's
/// factorisation, one thread; without enforcement and smoothing, which ours has.
static void localGlobalBesidePlain(benchmark::State& state) {
    const Subject& subject = subjectOf(state);
    LocalGlobal solver(subject.body, std::vector<char>(static_cast<std::size_t>(subject.body.V.rows()), 0),
                       0.1);
    const SideLabels sides = sidesOf(subject.body);
    const Directions directions = subject.frame.directionsToWork(subject.state.directions);
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(systemOf(subject.body));
    const std::vector<PlainTet> tets = plainTets(subject.body);
    Positions X = subject.body.V;
    Contest contest(state);
    for (auto _ : state)
        contest.round(
            [&] { benchmark::DoNotOptimize(solver.iterate(sides, directions, std::sin(radians(1)))); },
            [&] { X = factor.solve(plainRightHandSide(tets, X)); });
    contest.conclude("plain", "ms", 1e3);
}
BENCHMARK(localGlobalBesidePlain)->Apply(eachSubject)->Iterations(10);

/// One matrix, its pattern analysed before.
static void factorisation(benchmark::State& state) {
    const Eigen::SparseMatrix<double> A = systemOf(subjectOf(state).body);
    SparseSolver ours;
    ours.analyze(A);
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> eigen;
    eigen.analyzePattern(A);
    Contest contest(state);
    for (auto _ : state)
        contest.round([&] { benchmark::DoNotOptimize(ours.factor(A)); }, [&] { eigen.factorize(A); });
    contest.conclude("eigen", "ms", 1e3);
    state.counters["fell_back"] = ours.fellBack();
}
BENCHMARK(factorisation)->Apply(eachSubject)->MinTime(0.2);

/// A plastic restart: new rest shape, its Laplacian, factor and trial solve; beside the same factorisation by
/// CHOLMOD with METIS and OpenBLAS called directly, one thread.
static void plasticRestart(benchmark::State& state) {
    const Subject& subject = subjectOf(state);
    const auto points = static_cast<std::size_t>(subject.body.V.rows());
    LocalGlobal solver(subject.body, std::vector<char>(points, 0), 0.1);
    const Eigen::SparseMatrix<double> A = systemOf(subject.body);
    Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Lower> direct;
    direct.cholmod().nmethods = 1;
    direct.cholmod().method[0].ordering = CHOLMOD_METIS;
    direct.analyzePattern(A);
    Contest contest(state);
    for (auto _ : state)
        contest.round([&] { solver.restart(); }, [&] { direct.factorize(A); });
    contest.conclude("cholmod", "ms", 1e3);
}
BENCHMARK(plasticRestart)->Apply(eachSubject)->MinTime(0.2);

/// Matrices as a deformation meets them: rotations, somewhat strained. Times are per matrix, one thread.
static void rotationFit(benchmark::State& state) {
    constexpr int batches = 1000;
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    std::vector<MatrixBatch> F(batches);
    std::vector<MatrixBatch> R(batches);
    std::vector<Eigen::Matrix3d> single;
    for (MatrixBatch& batch : F)
        for (int lane = 0; lane < MatrixBatch::kLanes; ++lane) {
            const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
            const Eigen::Matrix3d strain = Eigen::Matrix3d::NullaryExpr([&] { return 0.2 * normal(random); });
            single.emplace_back(q.normalized().toRotationMatrix() + strain);
            for (int k = 0; k < 9; ++k)
                batch.m[k][lane] = single.back()(k / 3, k % 3);
        }
    Contest contest(state);
    for (auto _ : state)
        contest.round(
            [&] {
                for (std::size_t i = 0; i < F.size(); ++i)
                    fitRotations(F[i], R[i]);
                benchmark::DoNotOptimize(R.data());
            },
            [&] {
                for (const Eigen::Matrix3d& f : single) {
                    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
                    benchmark::DoNotOptimize(Eigen::Matrix3d(svd.matrixU() * svd.matrixV().transpose()));
                }
            });
    contest.conclude("eigen", "ns", 1e9 / static_cast<double>(single.size()));
}
BENCHMARK(rotationFit)->UseManualTime()->Unit(benchmark::kMillisecond);

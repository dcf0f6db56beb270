// SPDX-License-Identifier: AGPL-3.0-or-later
// What the deformation repeats: the local-global iteration beside what memory allows, factorisation and
// rotation fit beside Eigen's.
#include "benchmarks/subjects.h"
#include "benchmarks/timing.h"

#include "base/parallel.h"
#include "deformation/local_global.h"
#include "deformation/rotation_fit.h"
#include "deformation/sparse_solver.h"

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

/// A plastic restart: new weights and both factorisations of the plane's frame.
static void plasticRestart(benchmark::State& state) {
    const Subject& subject = subjectOf(state);
    const auto points = static_cast<std::size_t>(subject.body.V.rows());
    LocalGlobal solver(subject.body, std::vector<char>(points, 0), 0.1);
    Best best(state);
    for (auto _ : state)
        best.round([&] { solver.restart(); });
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

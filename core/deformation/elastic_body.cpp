// SPDX-License-Identifier: AGPL-3.0-or-later
// Compiled with -O3, so that the loops over lanes become vector code.
#include "deformation/elastic_body.h"

#include "base/parallel.h"
#include "base/vector_code.h"

#include <algorithm>
#include <array>

namespace moldwright {

namespace {

constexpr std::size_t kBlockGrain = 4; ///< blocks
constexpr std::size_t kPointGrain = 2048;

} // namespace

/// What a block works on: its points, and what it adds to them. Small enough for the processor's first cache.
struct ElasticBody::BlockNumbers {
    alignas(64) double x[3][kMostPlaces];
    alignas(64) double push[3][kMostPlaces];
};

Eigen::Quaterniond rotationAt(const Rotations& rotations, int lane) {
    const QuaternionBatch& batch = rotations[static_cast<std::size_t>(lane / QuaternionBatch::kLanes)];
    const int l = lane % QuaternionBatch::kLanes;
    return {batch.q[0][l], batch.q[1][l], batch.q[2][l], batch.q[3][l]};
}

void setRotation(Rotations& rotations, int lane, const Eigen::Quaterniond& q) {
    QuaternionBatch& batch = rotations[static_cast<std::size_t>(lane / QuaternionBatch::kLanes)];
    const int l = lane % QuaternionBatch::kLanes;
    batch.q[0][l] = q.w();
    batch.q[1][l] = q.x();
    batch.q[2][l] = q.y();
    batch.q[3][l] = q.z();
}

[[gnu::always_inline]] inline void
ElasticBody::deformationGradients(const Batch& batch, const BlockNumbers& numbers, MatrixBatch& F) {
    double edge[9][L]; // x_k − x_0, coordinate by coordinate
    for (int i = 0; i < 3; ++i)
#pragma GCC unroll 1 // unrolled, it would no longer become vector code
        for (int l = 0; l < L; ++l) {
            const double x0 = numbers.x[i][batch.corner[0][l]];
            edge[i][l] = numbers.x[i][batch.corner[1][l]] - x0;
            edge[3 + i][l] = numbers.x[i][batch.corner[2][l]] - x0;
            edge[6 + i][l] = numbers.x[i][batch.corner[3][l]] - x0;
        }
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int l = 0; l < L; ++l)
                F.m[3 * i + j][l] = edge[i][l] * batch.gradient[j][l] +
                                    edge[3 + i][l] * batch.gradient[3 + j][l] +
                                    edge[6 + i][l] * batch.gradient[6 + j][l];
}

[[gnu::always_inline]] inline void ElasticBody::scatter(const Batch& batch, const MatrixBatch& M,
                                                        double factor, BlockNumbers& numbers) {
    for (int i = 0; i < 3; ++i) {
        double push[4][L];
        for (int k = 0; k < 3; ++k)
            for (int l = 0; l < L; ++l)
                push[k + 1][l] = factor * batch.weight[l] *
                                 (M.m[3 * i][l] * batch.gradient[3 * k][l] +
                                  M.m[3 * i + 1][l] * batch.gradient[3 * k + 1][l] +
                                  M.m[3 * i + 2][l] * batch.gradient[3 * k + 2][l]);
        for (int l = 0; l < L; ++l)
            push[0][l] = -(push[1][l] + push[2][l] + push[3][l]);
        for (int k = 0; k < 4; ++k)
            for (int l = 0; l < L; ++l)
                numbers.push[i][batch.corner[k][l]] += push[k][l];
    }
}

/// Adds ν(det F − 1)² to the lanes' energies and half its derivative, ν(det F − 1)·cof F, to the residuals.
[[gnu::always_inline]] inline void ElasticBody::addVolumeTerm(const MatrixBatch& F, double stiffness,
                                                              MatrixBatch& residual, double* energies) {
    for (int l = 0; l < L; ++l) {
        const double f00 = F.m[0][l], f01 = F.m[1][l], f02 = F.m[2][l];
        const double f10 = F.m[3][l], f11 = F.m[4][l], f12 = F.m[5][l];
        const double f20 = F.m[6][l], f21 = F.m[7][l], f22 = F.m[8][l];
        const double c00 = f11 * f22 - f12 * f21, c01 = f12 * f20 - f10 * f22, c02 = f10 * f21 - f11 * f20;
        const double c10 = f21 * f02 - f22 * f01, c11 = f22 * f00 - f20 * f02, c12 = f20 * f01 - f21 * f00;
        const double c20 = f01 * f12 - f02 * f11, c21 = f02 * f10 - f00 * f12, c22 = f00 * f11 - f01 * f10;
        const double change = f00 * c00 + f01 * c01 + f02 * c02 - 1;
        const double push = stiffness * change;
        energies[l] += push * change;
        residual.m[0][l] += push * c00;
        residual.m[1][l] += push * c01;
        residual.m[2][l] += push * c02;
        residual.m[3][l] += push * c10;
        residual.m[4][l] += push * c11;
        residual.m[5][l] += push * c12;
        residual.m[6][l] += push * c20;
        residual.m[7][l] += push * c21;
        residual.m[8][l] += push * c22;
    }
}

/// Of a face only the part within it counts: ‖(F−R)P‖² = ‖F−R‖² − ‖(F−R)ν‖², ν the rest normal.
[[gnu::always_inline]] inline void
ElasticBody::removeNormalPart(const Batch& batch, const MatrixBatch& residual, double* energies) {
    const auto& g = batch.gradient;
    for (int l = 0; l < L; ++l) {
        const double x = g[1][l] * g[5][l] - g[2][l] * g[4][l];
        const double y = g[2][l] * g[3][l] - g[0][l] * g[5][l];
        const double z = g[0][l] * g[4][l] - g[1][l] * g[3][l];
        const double square = x * x + y * y + z * z;
        const double a = residual.m[0][l] * x + residual.m[1][l] * y + residual.m[2][l] * z;
        const double b = residual.m[3][l] * x + residual.m[4][l] * y + residual.m[5][l] * z;
        const double c = residual.m[6][l] * x + residual.m[7][l] * y + residual.m[8][l] * z;
        energies[l] -= (a * a + b * b + c * c) / (square > 0 ? square : 1.0);
    }
}

void ElasticBody::gather(const Block& block, const Positions& X, BlockNumbers& numbers) const {
    const int* point = m_pointOfPlace.data() + block.firstPlace;
    for (int i = 0; i < 3; ++i) {
        const double* x = X.col(i).data();
        for (std::size_t p = 0; p < block.places; ++p)
            numbers.x[i][p] = x[point[p]];
    }
}

/// Runs perBlock(block, numbers) over all blocks, points gathered if X is given; adds what it pushed to *out
/// if given; returns the sum of what it returned, in the order of the blocks.
template <class PerBlock>
double ElasticBody::overBlocks(const Positions* X, Positions* out, const PerBlock& perBlock) const {
    std::vector<double> sums(m_blocks.size());
    Positions pushes(out ? static_cast<Eigen::Index>(m_pointOfPlace.size()) : 0, 3);
    parallelFor(m_blocks.size(), kBlockGrain, [&](std::size_t begin, std::size_t end) {
        BlockNumbers numbers;
        for (std::size_t b = begin; b < end; ++b) {
            const Block& block = m_blocks[b];
            if (X)
                gather(block, *X, numbers);
            for (int i = 0; out && i < 3; ++i)
                std::fill_n(numbers.push[i], block.places, 0.0);
            sums[b] = perBlock(block, numbers);
            for (int i = 0; out && i < 3; ++i)
                std::copy_n(numbers.push[i], block.places, pushes.col(i).data() + block.firstPlace);
        }
    });
    if (out)
        parallelFor(static_cast<std::size_t>(m_points), kPointGrain, [&](std::size_t begin, std::size_t end) {
            for (int i = 0; i < 3; ++i) {
                double* o = out->col(i).data();
                const double* push = pushes.col(i).data();
                for (std::size_t v = begin; v < end; ++v)
                    for (int p = m_places.start[v]; p < m_places.start[v + 1]; ++p)
                        o[v] += push[m_places.members[static_cast<std::size_t>(p)]];
            }
        });
    double sum = 0;
    for (const double s : sums)
        sum += s;
    return sum;
}

double ElasticBody::energy(const Positions& X, double weight, Positions& gradient) const {
    return overBlocks(&X, &gradient, [&](const Block& block, BlockNumbers& numbers) {
        double sum = 0;
        inVectorCode([&] {
            alignas(64) double total[L] = {};
            for (std::size_t b = block.firstBatch; b < block.firstBatch + block.batches; ++b) {
                const Batch& batch = m_batches[b];
                MatrixBatch F;
                MatrixBatch residual;
                QuaternionBatch q;
                alignas(64) double energies[L] = {};
                deformationGradients(batch, numbers, F);
                fitQuaternions(F, q);
                toMatrices(q, residual);
                for (int k = 0; k < 9; ++k)
                    for (int l = 0; l < L; ++l) {
                        residual.m[k][l] = F.m[k][l] - residual.m[k][l];
                        energies[l] += residual.m[k][l] * residual.m[k][l];
                    }
                if (block.faces)
                    removeNormalPart(batch, residual, energies);
                else if (m_volumeStiffness > 0)
                    addVolumeTerm(F, m_volumeStiffness, residual, energies);
                scatter(batch, residual, 2 * weight, numbers);
                for (int l = 0; l < L; ++l)
                    total[l] += batch.weight[l] > 0 ? batch.weight[l] * energies[l] : 0.0;
            }
            for (const double lane : total)
                sum += lane;
        });
        return sum;
    });
}

void ElasticBody::fit(const Positions& X, Rotations& rotations) const {
    rotations.resize(m_batches.size());
    overBlocks(&X, nullptr, [&](const Block& block, BlockNumbers& numbers) {
        inVectorCode([&] {
            for (std::size_t b = block.firstBatch; b < block.firstBatch + block.batches; ++b) {
                MatrixBatch F;
                deformationGradients(m_batches[b], numbers, F);
                fitQuaternions(F, rotations[b]);
            }
        });
        return 0.0;
    });
}

Positions ElasticBody::rightHandSide(const Rotations& rotations) const {
    Positions rhs = Positions::Zero(m_points, 3);
    overBlocks(nullptr, &rhs, [&](const Block& block, BlockNumbers& numbers) {
        inVectorCode([&] {
            for (std::size_t b = block.firstBatch; b < block.firstBatch + block.batches; ++b) {
                MatrixBatch R;
                toMatrices(rotations[b], R);
                scatter(m_batches[b], R, 1, numbers);
            }
        });
        return 0.0;
    });
    return rhs;
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
// Compiled with -O3, so that the loops over lanes become vector code.
#include "deformation/rotation_smoothing.h"

#include "base/parallel.h"
#include "base/vector_code.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr double kLeast = 1e-300;
constexpr std::size_t kGrain = 256;                   ///< batches
constexpr int kNumbers = 4 * QuaternionBatch::kLanes; ///< in a batch of rotations

} // namespace

RotationSmoothing::RotationSmoothing(const ElasticBody& body,
                                     const std::vector<std::array<int, 4>>& neighbours)
    : m_batches(static_cast<std::size_t>(body.laneCount() / L)) {
    const auto placeOf = [](int lane) { return lane / L * kNumbers + lane % L; };
    for (int lane = 0; lane < body.laneCount(); ++lane)
        for (auto& row : m_batches[static_cast<std::size_t>(lane / L)].neighbour)
            row[lane % L] = placeOf(lane);
    for (std::size_t t = 0; t < neighbours.size(); ++t) {
        const int lane = body.laneOf(static_cast<int>(t));
        Batch& batch = m_batches[static_cast<std::size_t>(lane / L)];
        const auto count = 4 - std::count(neighbours[t].begin(), neighbours[t].end(), -1);
        for (std::size_t k = 0; k < 4; ++k) {
            if (neighbours[t][k] < 0)
                continue;
            batch.neighbour[k][lane % L] = placeOf(body.laneOf(neighbours[t][k]));
            batch.share[k][lane % L] = 1 / static_cast<double>(count);
        }
    }
}

void RotationSmoothing::apply(const Rotations& from, double gamma, Rotations& to) const {
    to.resize(from.size());
    const double* numbers = from.front().q[0];
    parallelFor(m_batches.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        inVectorCode([&] {
            for (std::size_t b = begin; b < end; ++b) {
                const Batch& batch = m_batches[b];
                const QuaternionBatch own = from[b];
                double sum[4][L] = {};
                double weight[L] = {};
                for (int k = 0; k < 4; ++k)
                    for (int l = 0; l < L; ++l) {
                        const int at = batch.neighbour[k][l];
                        const double w = numbers[at], x = numbers[at + L];
                        const double y = numbers[at + 2 * L], z = numbers[at + 3 * L];
                        const double cosine =
                            w * own.q[0][l] + x * own.q[1][l] + y * own.q[2][l] + z * own.q[3][l];
                        // q and −q are one rotation: the nearer of both.
                        const double share = cosine < 0 ? -batch.share[k][l] : batch.share[k][l];
                        sum[0][l] += share * w;
                        sum[1][l] += share * x;
                        sum[2][l] += share * y;
                        sum[3][l] += share * z;
                        weight[l] += batch.share[k][l];
                    }
                QuaternionBatch blended;
                for (int l = 0; l < L; ++l) {
                    const double blend = gamma * weight[l]; // a tetrahedron alone has weight 0
                    const double w = (1 - blend) * own.q[0][l] + blend * sum[0][l];
                    const double x = (1 - blend) * own.q[1][l] + blend * sum[1][l];
                    const double y = (1 - blend) * own.q[2][l] + blend * sum[2][l];
                    const double z = (1 - blend) * own.q[3][l] + blend * sum[3][l];
                    const double length = std::sqrt(w * w + x * x + y * y + z * z);
                    const double inverse = 1 / (length > kLeast ? length : kLeast);
                    blended.q[0][l] = w * inverse;
                    blended.q[1][l] = x * inverse;
                    blended.q[2][l] = y * inverse;
                    blended.q[3][l] = z * inverse;
                }
                to[b] = blended;
            }
        });
    });
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "deformation/elastic_body.h"

#include <array>
#include <vector>

namespace moldwright {

/// Blends the rotation of each tetrahedron with the mean of its neighbours'. [Stein 2019], Eq. (6).
class RotationSmoothing {
public:
    /// `neighbours`: of each tetrahedron across its faces, −1 outside.
    RotationSmoothing(const ElasticBody& body, const std::vector<std::array<int, 4>>& neighbours);

    /// (1−γ) q + γ · mean of the neighbours' q, normalised, for every lane of a tetrahedron; other lanes as
    /// they are. `from` and `to` are different.
    void apply(const Rotations& from, double gamma, Rotations& to) const;

private:
    static constexpr int L = QuaternionBatch::kLanes;

    /// Eight tetrahedra: their neighbours as places of q[0][lane] in the rotations, their own where there is
    /// none, and the share of each neighbour in the mean.
    struct alignas(64) Batch {
        int neighbour[4][L];
        double share[4][L];
    };
    std::vector<Batch> m_batches;
};

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace moldwright {

/// Eight 3×3 matrices side by side, entry by entry (row-major): m[3·row + column][lane].
struct alignas(64) MatrixBatch {
    static constexpr int kLanes = 8;
    double m[9][kLanes];
};

/// For each lane the rotation R (det +1) nearest to F: the one of largest tr(RᵀF), hence least ‖F − R‖.
/// Horn's quaternion: the largest eigenvector of a 4×4 matrix by Newton on its quartic; a proper rotation for
/// inverted F without a sign fix. Where the answer is not unique some nearest rotation is given. Error below
/// 1e-10 unless two rotations are nearly as good. [Horn 1987]
void fitRotations(const MatrixBatch& F, MatrixBatch& R);

/// The same for one matrix.
[[nodiscard]] Eigen::Matrix3d fitRotation(const Eigen::Matrix3d& F);

} // namespace moldwright

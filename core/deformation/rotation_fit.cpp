// SPDX-License-Identifier: AGPL-3.0-or-later
// Compiled with -O3, so that the loops over lanes become vector code.
#include "deformation/rotation_fit.h"

#include "base/vector_code.h"
#include "deformation/rotation_lanes.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace moldwright {

namespace {

constexpr int L = MatrixBatch::kLanes;

Eigen::Matrix3d fitBySvd(const Eigen::Matrix3d& F) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d U = svd.matrixU();
    if ((U * svd.matrixV().transpose()).determinant() < 0)
        U.col(2) = -U.col(2);
    return U * svd.matrixV().transpose();
}

} // namespace

void detail::fitPoorLanes(const MatrixBatch& F, const double* pivot, QuaternionBatch& q) {
    for (int l = 0; l < L; ++l) {
        if (pivot[l] > kPoorPivot)
            continue;
        Eigen::Matrix3d one;
        for (int k = 0; k < 9; ++k)
            one(k / 3, k % 3) = F.m[k][l];
        const Eigen::Quaterniond rotation(fitBySvd(one));
        q.q[0][l] = rotation.w();
        q.q[1][l] = rotation.x();
        q.q[2][l] = rotation.y();
        q.q[3][l] = rotation.z();
    }
}

void fitRotations(const MatrixBatch& F, MatrixBatch& R) {
    inVectorCode([&] {
        QuaternionBatch q;
        fitQuaternions(F, q);
        toMatrices(q, R);
    });
}

Eigen::Matrix3d fitRotation(const Eigen::Matrix3d& F) {
    MatrixBatch batch;
    for (int k = 0; k < 9; ++k)
        for (int l = 0; l < L; ++l)
            batch.m[k][l] = F(k / 3, k % 3);
    MatrixBatch fitted;
    fitRotations(batch, fitted);
    Eigen::Matrix3d R;
    for (int k = 0; k < 9; ++k)
        R(k / 3, k % 3) = fitted.m[k][0];
    return R;
}

} // namespace moldwright

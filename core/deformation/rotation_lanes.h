// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "deformation/rotation_fit.h"

#include <cmath>
#include <limits>

namespace moldwright {

/// Unit quaternions of eight rotations: w, x, y, z.
struct alignas(64) QuaternionBatch {
    static constexpr int kLanes = MatrixBatch::kLanes;
    double q[4][kLanes];
};

namespace detail {

/// Where no lane moves by more than this share any more, Newton's method has arrived.
constexpr double kArrived = 4e-16;
constexpr int kNewtonSteps = 14;
/// Below this pivot the closed form has lost its digits.
constexpr double kPoorPivot = 1e-6;

/// The largest root of λ⁴ + c2 λ² + c1 λ + c0, lane by lane.
struct alignas(64) LaneQuartic {
    static constexpr int L = MatrixBatch::kLanes;
    double c2[L], c1[L], c0[L], lambda[L];

    /// Newton from above falls monotonically on the largest root: a few steps near a rotation, many where two
    /// roots are close.
    [[gnu::always_inline]] void solve() {
        for (int i = 0; i < kNewtonSteps; ++i) {
            double moved[L];
#pragma GCC unroll 1 // unrolled, it would no longer become vector code
            for (int l = 0; l < L; ++l) {
                const double l2 = lambda[l] * lambda[l];
                const double value = (l2 + c2[l]) * l2 + c1[l] * lambda[l] + c0[l];
                const double slope = (4 * l2 + 2 * c2[l]) * lambda[l] + c1[l];
                const double step = value / (slope > 0 ? slope : std::numeric_limits<double>::infinity());
                // A lane that has arrived stays, whatever its neighbours still do.
                moved[l] = std::abs(step) > kArrived * lambda[l] ? 1.0 : 0.0;
                lambda[l] -= moved[l] * step;
            }
            double moving = 0;
            for (const double lane : moved)
                moving += lane;
            if (moving == 0)
                break;
        }
    }
};

/// Lanes whose pivot is poor are fitted again, by a singular value decomposition.
[[gnu::noinline]] void fitPoorLanes(const MatrixBatch& F, const double* pivot, QuaternionBatch& q);

} // namespace detail

/// The quaternions of fitRotations(), for loops that become vector code.
[[gnu::always_inline]] inline void fitQuaternions(const MatrixBatch& F, QuaternionBatch& result) {
    constexpr int L = MatrixBatch::kLanes;
    detail::LaneQuartic quartic;
    alignas(64) double pivot[L];
    for (int l = 0; l < L; ++l) {
        const double f00 = F.m[0][l], f01 = F.m[1][l], f02 = F.m[2][l];
        const double f10 = F.m[3][l], f11 = F.m[4][l], f12 = F.m[5][l];
        const double f20 = F.m[6][l], f21 = F.m[7][l], f22 = F.m[8][l];

        // K with qᵀKq = tr(R(q)ᵀF) for unit quaternions q.
        const double k00 = f00 + f11 + f22, k11 = f00 - f11 - f22, k22 = f11 - f00 - f22,
                     k33 = f22 - f00 - f11;
        const double k01 = f21 - f12, k02 = f02 - f20, k03 = f10 - f01;
        const double k12 = f01 + f10, k13 = f02 + f20, k23 = f12 + f21;

        // Its characteristic polynomial λ⁴ + c2 λ² + c1 λ + c0; the trace is zero.
        const double square = f00 * f00 + f01 * f01 + f02 * f02 + f10 * f10 + f11 * f11 + f12 * f12 +
                              f20 * f20 + f21 * f21 + f22 * f22;
        const double det =
            f00 * (f11 * f22 - f12 * f21) - f01 * (f10 * f22 - f12 * f20) + f02 * (f10 * f21 - f11 * f20);
        const double c2 = -2 * square;
        const double c1 = -8 * det;
        const double a0 = k00 * k11 - k01 * k01, a1 = k00 * k12 - k01 * k02, a2 = k00 * k13 - k01 * k03;
        const double a3 = k01 * k12 - k11 * k02, a4 = k01 * k13 - k11 * k03, a5 = k02 * k13 - k12 * k03;
        const double b0 = k02 * k13 - k03 * k12, b1 = k02 * k23 - k03 * k22, b2 = k02 * k33 - k03 * k23;
        const double b3 = k12 * k23 - k13 * k22, b4 = k12 * k33 - k13 * k23, b5 = k22 * k33 - k23 * k23;
        const double c0 = a0 * b5 - a1 * b4 + a2 * b3 + a3 * b2 - a4 * b1 + a5 * b0;

        quartic.c2[l] = c2;
        quartic.c1[l] = c1;
        quartic.c0[l] = c0;
        quartic.lambda[l] = std::sqrt(3 * square); // ≥ the largest root
    }
    quartic.solve();
    for (int l = 0; l < L; ++l) {
        const double lambda = quartic.lambda[l];
        const double f00 = F.m[0][l], f01 = F.m[1][l], f02 = F.m[2][l];
        const double f10 = F.m[3][l], f11 = F.m[4][l], f12 = F.m[5][l];
        const double f20 = F.m[6][l], f21 = F.m[7][l], f22 = F.m[8][l];

        // K with qᵀKq = tr(R(q)ᵀF) for unit quaternions q.
        const double k00 = f00 + f11 + f22, k11 = f00 - f11 - f22, k22 = f11 - f00 - f22,
                     k33 = f22 - f00 - f11;
        const double k01 = f21 - f12, k02 = f02 - f20, k03 = f10 - f01;
        const double k12 = f01 + f10, k13 = f02 + f20, k23 = f12 + f21;

        // The eigenvector is any column of the adjugate of M = K − λI; the one with the largest diagonal is
        // taken.
        const double m00 = k00 - lambda, m11 = k11 - lambda, m22 = k22 - lambda, m33 = k33 - lambda;
        const double p01 = m22 * m33 - k23 * k23, p02 = k12 * m33 - k23 * k13, p03 = k12 * k23 - m22 * k13;
        const double p12 = m11 * m33 - k13 * k13, p13 = m11 * k23 - k12 * k13, p23 = m11 * m22 - k12 * k12;
        const double q02 = k02 * m33 - k23 * k03, q03 = k02 * k23 - m22 * k03;
        const double q12 = k01 * m33 - k13 * k03, q13 = k01 * k23 - k13 * k02;
        const double r12 = k01 * k23 - k12 * k03, r23 = k01 * m22 - k12 * k02, r13 = k01 * k13 - m11 * k03;
        const double r33 = k01 * k12 - m11 * k02;
        const double adj00 = m11 * p01 - k12 * p02 + k13 * p03;
        const double adj01 = -(k01 * p01 - k12 * q02 + k13 * q03);
        const double adj02 = k01 * p02 - m11 * q02 + k13 * (k02 * k13 - k12 * k03);
        const double adj03 = -(k01 * p03 - m11 * q03 + k12 * (k02 * k13 - k12 * k03));
        const double adj11 = m00 * p01 - k02 * q02 + k03 * q03;
        const double adj12 = -(m00 * p02 - k02 * q12 + k03 * r12);
        const double adj13 = m00 * p03 - k02 * q13 + k03 * r23;
        const double adj22 = m00 * p12 - k01 * q12 + k03 * r13;
        const double adj23 = -(m00 * p13 - k01 * q13 + k03 * r33);
        const double adj33 = m00 * p23 - k01 * r23 + k02 * r33;

        const double d0 = std::abs(adj00), d1 = std::abs(adj11), d2 = std::abs(adj22), d3 = std::abs(adj33);
        const bool first = d0 >= d1;
        const double dA = first ? d0 : d1;
        const double wA = first ? adj00 : adj01, xA = first ? adj01 : adj11;
        const double yA = first ? adj02 : adj12, zA = first ? adj03 : adj13;
        const bool third = d2 >= d3;
        const double dB = third ? d2 : d3;
        const double wB = third ? adj02 : adj03, xB = third ? adj12 : adj13;
        const double yB = third ? adj22 : adj23, zB = third ? adj23 : adj33;
        const bool useA = dA >= dB;
        const double w0 = useA ? wA : wB, x0 = useA ? xA : xB, y0 = useA ? yA : yB, z0 = useA ? zA : zB;
        const double length = std::sqrt(w0 * w0 + x0 * x0 + y0 * y0 + z0 * z0);
        const double inverse = length > 0 ? 1 / length : 0.0;
        const double w = w0 * inverse, x = x0 * inverse, y = y0 * inverse, z = z0 * inverse;
        const double scale = lambda * lambda * lambda;
        const double quality = scale > 0 ? (useA ? dA : dB) / scale : 0.0;

        result.q[0][l] = w;
        result.q[1][l] = x;
        result.q[2][l] = y;
        result.q[3][l] = z;
        pivot[l] = quality;
    }
    double poor = 0;
    for (const double p : pivot)
        poor += p > detail::kPoorPivot ? 0.0 : 1.0;
    if (poor > 0)
        detail::fitPoorLanes(F, pivot, result);
}

/// Their matrices.
[[gnu::always_inline]] inline void toMatrices(const QuaternionBatch& from, MatrixBatch& R) {
    constexpr int L = MatrixBatch::kLanes;
    for (int l = 0; l < L; ++l) {
        const double w = from.q[0][l], x = from.q[1][l], y = from.q[2][l], z = from.q[3][l];
        R.m[0][l] = 1 - 2 * (y * y + z * z);
        R.m[1][l] = 2 * (x * y - w * z);
        R.m[2][l] = 2 * (x * z + w * y);
        R.m[3][l] = 2 * (x * y + w * z);
        R.m[4][l] = 1 - 2 * (x * x + z * z);
        R.m[5][l] = 2 * (y * z - w * x);
        R.m[6][l] = 2 * (x * z - w * y);
        R.m[7][l] = 2 * (y * z + w * x);
        R.m[8][l] = 1 - 2 * (x * x + y * y);
    }
}

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/rotation_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <numbers>
#include <random>

using namespace moldwright;

namespace {

/// The answer by a singular value decomposition, and how far ahead of the second best it is.
struct BySvd {
    explicit BySvd(const Eigen::Matrix3d& F) {
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
        const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
        R = svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
        const Eigen::Vector3d& s = svd.singularValues();
        best = s[0] + s[1] + sign * s[2];
        lead = s[1] + sign * s[2];
    }
    Eigen::Matrix3d R;
    double best = 0;
    double lead = 0;
};

class RotationFit : public testing::Test {
protected:
    Eigen::Matrix3d anyMatrix() {
        return Eigen::Matrix3d::NullaryExpr([&] { return m_number(m_random); });
    }
    Eigen::Matrix3d anyRotation() { return BySvd(anyMatrix()).R; }

    std::mt19937 m_random{7};
    std::uniform_real_distribution<double> m_number{-1, 1};
};

void expectProperAndBest(const Eigen::Matrix3d& R, const Eigen::Matrix3d& F, double tolerance) {
    EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_GT(R.determinant(), 0);
    EXPECT_NEAR((R.transpose() * F).trace(), BySvd(F).best, tolerance) << F;
}

} // namespace

TEST_F(RotationFit, AgreesWithTheSvdOnAnyMatrixReflectionsToo) {
    int reflections = 0;
    int compared = 0;
    for (int i = 0; i < 2000; ++i) {
        const Eigen::Matrix3d F = anyMatrix();
        reflections += F.determinant() < 0;
        const Eigen::Matrix3d R = fitRotation(F);
        expectProperAndBest(R, F, 1e-12);
        const BySvd answer(F);
        if (answer.lead > 0.01) {
            EXPECT_LT((R - answer.R).norm(), 1e-9) << F;
            ++compared;
        }
    }
    EXPECT_GT(reflections, 800);
    EXPECT_GT(compared, 1900);
}

TEST_F(RotationFit, FindsRotationsNearAHalfTurn) {
    for (const double less : {1e-3, 1e-6, 1e-9, 0.0})
        for (int i = 0; i < 50; ++i) {
            const Eigen::Vector3d axis = anyMatrix().col(0).normalized();
            const Eigen::Matrix3d turn = Eigen::AngleAxisd(std::numbers::pi - less, axis).toRotationMatrix();
            const Eigen::Matrix3d S = anyMatrix();
            const Eigen::Matrix3d stretch = S * S.transpose() + 0.2 * Eigen::Matrix3d::Identity();
            EXPECT_LT((fitRotation(turn * stretch) - turn).norm(), 1e-9);
        }
}

TEST_F(RotationFit, TakesTheBestOfMatricesWithoutFullRank) {
    for (int i = 0; i < 200; ++i) {
        const Eigen::Matrix3d R = anyRotation();
        const Eigen::Matrix3d Q = anyRotation();
        const Eigen::Matrix3d sheet = R * Eigen::Vector3d(1, 0.4, 0).asDiagonal() * Q;
        EXPECT_LT((fitRotation(sheet) - BySvd(sheet).R).norm(), 1e-9);
        const Eigen::Matrix3d line = R * Eigen::Vector3d(1, 0, 0).asDiagonal() * Q;
        expectProperAndBest(fitRotation(line), line, 1e-7);
    }
    expectProperAndBest(fitRotation(Eigen::Matrix3d::Zero()), Eigen::Matrix3d::Zero(), 0);
}

TEST_F(RotationFit, HoldsWhereTwoRotationsAreEquallyGood) {
    // A point reflection has no nearest rotation of its own: any half turn is as good.
    expectProperAndBest(fitRotation(-Eigen::Matrix3d::Identity()), -Eigen::Matrix3d::Identity(), 1e-7);
    const Eigen::Matrix3d mirror = Eigen::Vector3d(1, 1, -1).asDiagonal();
    expectProperAndBest(fitRotation(mirror), mirror, 1e-7);
}

TEST_F(RotationFit, DoesNotMindTheScale) {
    for (const double scale : {1e-9, 1e6}) {
        const Eigen::Matrix3d F = anyRotation() * Eigen::Vector3d(1, 0.8, 0.6).asDiagonal();
        EXPECT_LT((fitRotation(scale * F) - fitRotation(F)).norm(), 1e-9) << scale;
    }
}

TEST_F(RotationFit, LanesDoNotDisturbEachOther) {
    MatrixBatch F{};
    std::vector<Eigen::Matrix3d> matrices;
    for (int lane = 0; lane < MatrixBatch::kLanes; ++lane) {
        matrices.push_back(anyMatrix());
        for (int k = 0; k < 9; ++k)
            F.m[k][lane] = matrices.back()(k / 3, k % 3);
    }
    MatrixBatch R{};
    fitRotations(F, R);
    for (int lane = 0; lane < MatrixBatch::kLanes; ++lane) {
        const Eigen::Matrix3d alone = fitRotation(matrices[static_cast<std::size_t>(lane)]);
        for (int k = 0; k < 9; ++k)
            EXPECT_EQ(R.m[k][lane], alone(k / 3, k % 3));
    }
}

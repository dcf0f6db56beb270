// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/surface_binding.h"

#include "mesh/decimate.h"
#include "support/shapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <numbers>

using namespace moldwright;

namespace {

const IndexedMesh& fine() {
    static const IndexedMesh mesh = test::torus(2, 0.7, 60, 40);
    return mesh;
}

const Reduction& coarse() {
    static const Reduction reduction = reduce(fine(), 800);
    return reduction;
}

/// A box whose sides are each cut in two again and again.
IndexedMesh fineBox(const Eigen::Vector3d& lo, const Eigen::Vector3d& hi) {
    IndexedMesh mesh = test::box(lo, hi);
    for (int round = 0; round < 4; ++round)
        mesh = test::splitInFour(mesh);
    return mesh;
}

} // namespace

TEST(SurfaceBinding, LeavesThePointsWhereTheyAreAtRest) {
    const SurfaceBinding binding(coarse().mesh, fine().V, coarse().pointNow);
    EXPECT_LT((binding.carry(coarse().mesh.V) - fine().V).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SurfaceBinding, CarriesARigidMotionExactly) {
    const SurfaceBinding binding(coarse().mesh, fine().V, coarse().pointNow);
    const Eigen::Matrix3d Q = Eigen::AngleAxisd(1.3, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
    const auto moved = [&](const Points& X) {
        return Points((X * Q.transpose()).rowwise() + Eigen::RowVector3d(3, -1, 2));
    };
    EXPECT_LT((binding.carry(moved(coarse().mesh.V)) - moved(fine().V)).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(SurfaceBinding, FollowsASmoothBendClosely) {
    const SurfaceBinding binding(coarse().mesh, fine().V, coarse().pointNow);
    const auto bent = [](Points X) {
        for (Eigen::Index v = 0; v < X.rows(); ++v)
            X(v, 2) += 0.1 * X(v, 0) * X(v, 0);
        return X;
    };
    EXPECT_LT((binding.carry(bent(coarse().mesh.V)) - bent(fine().V)).cwiseAbs().maxCoeff(), 0.02);
}

TEST(SurfaceBinding, TiesAPointToItsOwnSheetThoughAnotherIsNear) {
    // A plate so thin that from a point of its top the coarse bottom may be nearer; only the top bulges.
    const IndexedMesh plate = fineBox({0, 0, 0}, {10, 10, 0.02});
    const Reduction thin = reduce(plate, 400);
    const SurfaceBinding binding(thin.mesh, plate.V, thin.pointNow);
    const auto bulged = [](Points X) {
        for (Eigen::Index v = 0; v < X.rows(); ++v)
            if (X(v, 2) > 0.01)
                X(v, 2) +=
                    std::sin(std::numbers::pi * X(v, 0) / 10) * std::sin(std::numbers::pi * X(v, 1) / 10);
        return X;
    };
    const Points carried = binding.carry(bulged(thin.mesh.V));
    const Points wanted = bulged(plate.V);
    for (Eigen::Index v = 0; v < plate.V.rows(); ++v) {
        const bool inTheMiddle = (plate.V.row(v).head<2>() - Eigen::RowVector2d(5, 5)).norm() < 2.5;
        if (inTheMiddle) {
            EXPECT_NEAR(carried(v, 2), wanted(v, 2), 0.3) << "the sheets are 0.6 to 1 apart here";
        }
    }
}

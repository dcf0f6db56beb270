// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/surface_binding.h"

#include "mesh/decimate.h"
#include "support/shapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

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
    // A thin plate: seen from a point of the top, the coarse bottom may be the nearer one.
    const IndexedMesh plate = fineBox({0, 0, 0}, {10, 10, 0.02});
    const Reduction thin = reduce(plate, 60);
    const SurfaceBinding binding(thin.mesh, plate.V, thin.pointNow);
    Points lifted = thin.mesh.V;
    for (Eigen::Index v = 0; v < lifted.rows(); ++v)
        if (lifted(v, 2) > 0.01)
            lifted(v, 2) += 1;
    const Points carried = binding.carry(lifted);
    for (Eigen::Index v = 0; v < plate.V.rows(); ++v) {
        const bool onRim =
            plate.V(v, 0) < 0.7 || plate.V(v, 0) > 9.3 || plate.V(v, 1) < 0.7 || plate.V(v, 1) > 9.3;
        if (!onRim)
            EXPECT_NEAR(carried(v, 2), plate.V(v, 2) + (plate.V(v, 2) > 0.01 ? 1 : 0), 0.3);
    }
}

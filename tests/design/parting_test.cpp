// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/parting.h"

#include "deformation/tet_topology.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace moldwright;

namespace {

const IndexedMesh& ball() {
    static const IndexedMesh mesh = test::sphere({1, 2, 3}, 10, 3);
    return mesh;
}

} // namespace

TEST(PartSolid, FillsThePartedPartWithTetrahedra) {
    const MoldState state{{Eigen::Vector3d(1, 1, 4).normalized(), 2}, {}};
    const Result<PartedSolid> solid = partSolid(ball(), state, {});
    ASSERT_TRUE(solid) << solid.error().english();
    const IndexedMesh& surface = solid->surface.mesh;
    EXPECT_TRUE(diagnose(surface).usable());
    EXPECT_EQ(solid->tets.V.topRows(surface.vertexCount()), surface.V) << "surface points come first";
    EXPECT_EQ(invertedCount(solid->tets.T, solid->tets.V), 0);
    for (const int tet : tetsBehindFaces(solid->tets.T, surface.F))
        EXPECT_GE(tet, 0);
    for (int f = 0; f < surface.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            EXPECT_GE(surface.corner(f, k).z() *
                          (solid->surface.labels[static_cast<std::size_t>(f)] == 1 ? 1 : -1),
                      0);
    const double scale = solid->frame.scale();
    EXPECT_NEAR(volume(surface) * scale * scale * scale, volume(ball()), 0.01 * volume(ball()));
}

TEST(PartSolid, RefusesWhatCanNeverLeave) {
    const IndexedMesh ring =
        test::rotated(test::torus(20, 5, 40, 16), Eigen::Vector3d::UnitX(), std::numbers::pi / 2);
    const Result<PartedSolid> solid = partSolid(ring, {}, {});
    ASSERT_FALSE(solid);
    EXPECT_EQ(solid.error().code, ErrorCode::Impossible);
    ASSERT_EQ(solid.error().places.size(), 1U);
    EXPECT_NEAR(std::abs(solid.error().places[0].z()), 12.5, 1);
}

TEST(PartSolid, EndsWhenCancelled) {
    const Task task;
    task.cancel();
    const Result<PartedSolid> solid = partSolid(ball(), {}, task);
    ASSERT_FALSE(solid);
    EXPECT_EQ(solid.error().code, ErrorCode::Cancelled);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/tetrahedralize.h"

#include "exchange/mesh_file.h"
#include "mesh/measures.h"
#include "support/folders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

double sumOfVolumes(const TetMesh& tets) {
    double sum = 0;
    for (int t = 0; t < tets.T.rows(); ++t) {
        const Eigen::RowVector3d a = tets.V.row(tets.T(t, 0));
        const Eigen::RowVector3d b = tets.V.row(tets.T(t, 1)) - a;
        const double sixfold = b.dot((tets.V.row(tets.T(t, 2)) - a).cross(tets.V.row(tets.T(t, 3)) - a));
        EXPECT_GT(sixfold, 0);
        sum += sixfold / 6;
    }
    return sum;
}

} // namespace

TEST(Tetrahedralize, FillsASphereAndKeepsItsSurface) {
    const IndexedMesh sphere = test::sphere({0.1, 0.2, 0.3}, 0.5, 3);
    const auto tets = tetrahedralize(sphere);
    ASSERT_TRUE(tets) << tets.error().english();
    EXPECT_EQ(tets->V.topRows(sphere.V.rows()), sphere.V);
    EXPECT_NEAR(sumOfVolumes(*tets), volume(sphere), 1e-9);
    EXPECT_GT(tets->V.rows(), sphere.V.rows());
}

TEST(Tetrahedralize, TakesPointsInsideAndRefusesThoseOutside) {
    const IndexedMesh sphere = test::sphere({0, 0, 0}, 0.5, 3);
    Points inside(2, 3);
    inside << 0.1, 0.2, 0.123456789, 0, 0, -0.45;
    const auto tets = tetrahedralize(sphere, {}, kTetGenSwitches, inside);
    ASSERT_TRUE(tets) << tets.error().english();
    EXPECT_EQ(tets->V.topRows(sphere.V.rows()), sphere.V);
    EXPECT_NEAR(sumOfVolumes(*tets), volume(sphere), 1e-9);
    const std::vector<int> found = innerPoints(*tets, sphere.vertexCount(), inside);
    for (Eigen::Index i = 0; i < 2; ++i)
        EXPECT_EQ(tets->V.row(found[static_cast<std::size_t>(i)]), inside.row(i));
    inside.row(1) << 0, 0, 0.7;
    EXPECT_FALSE(tetrahedralize(sphere, {}, kTetGenSwitches, inside));
}

TEST(Tetrahedralize, FillsARing) {
    const auto ring = test::torus(0.4, 0.1, 40, 16);
    const auto tets = tetrahedralize(ring);
    ASSERT_TRUE(tets) << tets.error().english();
    EXPECT_NEAR(sumOfVolumes(*tets), volume(ring), 1e-9);
}

TEST(Tetrahedralize, IsTheSameEveryTime) {
    const IndexedMesh sphere = test::sphere({0, 0, 0}, 0.5, 2);
    const auto once = tetrahedralize(sphere);
    const auto again = tetrahedralize(sphere);
    ASSERT_TRUE(once && again);
    EXPECT_EQ(once->V, again->V);
    EXPECT_EQ(once->T, again->T);
}

TEST(Tetrahedralize, AnOpenSurfaceIsAnErrorNotACrash) {
    IndexedMesh open = test::sphere({0, 0, 0}, 0.5, 2);
    open.F.conservativeResize(open.F.rows() - 4, Eigen::NoChange);
    const auto tets = tetrahedralize(open);
    ASSERT_FALSE(tets);
    EXPECT_EQ(tets.error().code, ErrorCode::Worker);
}

TEST(Tetrahedralize, SurfacesThatCrossAreAnErrorNotACrash) {
    const auto crossing =
        test::together(test::sphere({0, 0, 0}, 0.5, 2), test::sphere({0.2, 0.1, 0}, 0.5, 2));
    const auto tets = tetrahedralize(crossing);
    ASSERT_FALSE(tets);
    EXPECT_EQ(tets.error().code, ErrorCode::Worker);
}

TEST(Tetrahedralize, ACancelledTaskAnswersCancelled) {
    const Task task;
    task.cancel();
    const auto tets = tetrahedralize(test::sphere({0, 0, 0}, 0.5, 2), task);
    ASSERT_FALSE(tets);
    EXPECT_EQ(tets.error().code, ErrorCode::Cancelled);
}

// Thin limbs, sharp creases and the slivers of a CAD tessellation.
TEST(Tetrahedralize, FillsRealModels) {
    if (!test::models())
        GTEST_SKIP() << "MOLDWRIGHT_MODELS is not set";
    for (const char* name : {"spot.obj", "beam.stl", "xy_joint_upper.stl"}) {
        const auto read = readMesh(*test::models() / name);
        ASSERT_TRUE(read) << read.error().english();
        IndexedMesh mesh = read->mesh;
        mesh.V = ((mesh.V.rowwise() - boundingBox(mesh).center().transpose()) / diagonal(mesh)).eval();
        const auto tets = tetrahedralize(mesh);
        ASSERT_TRUE(tets) << name << ": " << tets.error().english();
        EXPECT_NEAR(sumOfVolumes(*tets), volume(mesh), 1e-9) << name;
    }
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/repair_mesh.h"

#include "exchange/mesh_file.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "support/folders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

using namespace moldwright;

namespace {

/// Usable, as examine() sees it.
void expectUsable(const Result<RepairedMesh>& repaired) {
    ASSERT_TRUE(repaired) << repaired.error().english();
    EXPECT_TRUE(examine(repaired->mesh, "repaired").faults.empty());
}

IndexedMesh withoutFaces(IndexedMesh mesh, const std::vector<int>& gone) {
    std::vector<int> kept;
    for (int f = 0; f < mesh.faceCount(); ++f)
        if (std::ranges::find(gone, f) == gone.end())
            kept.push_back(f);
    mesh.F = mesh.F(kept, Eigen::all).eval();
    return mesh;
}

} // namespace

TEST(RepairMesh, LeavesASoundMeshAsItIs) {
    const IndexedMesh ball = test::sphere({1, 2, 3}, 4, 2);
    const Result<RepairedMesh> repaired = repairMesh(ball, "ball");
    expectUsable(repaired);
    EXPECT_EQ(repaired->mesh.V, ball.V);
    EXPECT_EQ(repaired->mesh.F, ball.F);
    EXPECT_TRUE(repaired->repairs.empty());
}

TEST(RepairMesh, FillsAHoleInABallRoundly) {
    const IndexedMesh ball = test::sphere({0, 0, 0}, 10, 4);
    std::vector<int> cap;
    for (int f = 0; f < ball.faceCount(); ++f)
        if (ball.corner(f, 0).z() > 7)
            cap.push_back(f);
    const Result<RepairedMesh> repaired = repairMesh(withoutFaces(ball, cap), "ball");
    expectUsable(repaired);
    // The cap holds 0.0607 of the ball; a rim that steps by faces is no flat hole.
    EXPECT_NEAR(volume(repaired->mesh) / volume(ball), 1, 0.03);
    EXPECT_EQ(repaired->movedBy, 0);
    EXPECT_EQ(repaired->repairs.front().arguments.front(), "1");
}

TEST(RepairMesh, FillsABoxesMissingSideFlat) {
    const IndexedMesh box = test::splitInFour(test::splitInFour(test::box({0, 0, 0}, {3, 2, 1})));
    std::vector<int> top;
    for (int f = 0; f < box.faceCount(); ++f)
        if (box.corner(f, 0).z() == 1 && box.corner(f, 1).z() == 1 && box.corner(f, 2).z() == 1)
            top.push_back(f);
    ASSERT_FALSE(top.empty());
    const Result<RepairedMesh> repaired = repairMesh(withoutFaces(box, top), "box");
    expectUsable(repaired);
    EXPECT_NEAR(volume(repaired->mesh), 6, 1e-9);
}

TEST(RepairMesh, DropsAStrayFaceAndAnInnerSurface) {
    IndexedMesh mesh = test::together(test::sphere({0, 0, 0}, 10, 3), test::sphere({1, 0, 0}, 3, 2));
    const double outer = volume(test::sphere({0, 0, 0}, 10, 3));
    const Result<RepairedMesh> without = repairMesh(mesh, "nested");
    expectUsable(without);
    EXPECT_NEAR(volume(without->mesh), outer, 1e-6 * outer);
    mesh = test::sphere({0, 0, 0}, 10, 3);
    mesh.V.conservativeResize(mesh.V.rows() + 3, Eigen::NoChange);
    mesh.V.bottomRows(3) << 20, 0, 0, 21, 0, 0, 20, 1, 0;
    mesh.F.conservativeResize(mesh.F.rows() + 1, Eigen::NoChange);
    mesh.F.bottomRows(1) << mesh.vertexCount() - 3, mesh.vertexCount() - 2, mesh.vertexCount() - 1;
    const Result<RepairedMesh> alone = repairMesh(mesh, "stray");
    expectUsable(alone);
    EXPECT_NEAR(volume(alone->mesh), outer, 1e-6 * outer);
}

TEST(RepairMesh, MakesOneSolidOfBallsThatCross) {
    const Result<RepairedMesh> repaired =
        repairMesh(test::together(test::sphere({0, 0, 0}, 10, 4), test::sphere({12, 0, 0}, 10, 4)), "balls");
    expectUsable(repaired);
    // Two balls less the lens they share, whose caps are 4 high.
    const double ball = 4.0 / 3 * std::numbers::pi * 1000;
    const double lens = 2 * std::numbers::pi * 16 * (30 - 4) / 3;
    EXPECT_NEAR(volume(repaired->mesh) / (2 * ball - lens), 1, 0.02);
}

TEST(RepairMesh, RefusesWhatEnclosesNothing) {
    const IndexedMesh ball = test::sphere({0, 0, 0}, 10, 3);
    std::vector<int> most;
    for (int f = 0; f < ball.faceCount(); ++f)
        if (ball.corner(f, 0).z() < 9.5)
            most.push_back(f);
    IndexedMesh sheet = withoutFaces(ball, most);
    sheet.V.col(2).setConstant(1);
    const Result<RepairedMesh> repaired = repairMesh(sheet, "sheet");
    ASSERT_FALSE(repaired);
    EXPECT_EQ(repaired.error().code, ErrorCode::BadInput);
    EXPECT_NE(repaired.error().english().find("encloses nothing"), std::string::npos);
}

TEST(RepairMesh, EndsWhenCancelled) {
    Task task;
    task.cancel();
    EXPECT_FALSE(repairMesh(withoutFaces(test::sphere({0, 0, 0}, 10, 3), {0}), "ball", task));
}

TEST(RepairMesh, MendsBadModelsOrSaysWhyNot) {
    if (!test::badModels())
        GTEST_SKIP() << "MOLDWRIGHT_BAD_MODELS is not set";
    int mended = 0;
    for (const auto& entry : std::filesystem::directory_iterator(*test::badModels())) {
        const Result<ReadMesh> read = readMesh(entry.path());
        const std::string name = entry.path().filename();
        if (!read || examine(read->mesh, name).faults.empty())
            continue;
        SCOPED_TRACE(name);
        const Result<RepairedMesh> repaired = repairMesh(read->mesh, name);
        if (!repaired) {
            EXPECT_EQ(repaired.error().code, ErrorCode::BadInput) << repaired.error().english();
            continue;
        }
        ++mended;
        EXPECT_TRUE(examine(repaired->mesh, name).faults.empty());
    }
    EXPECT_GT(mended, 25);
}

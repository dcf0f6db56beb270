// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/check.h"

#include "mesh/measures.h"
#include "mesh/weld.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <random>

using namespace moldwright;

namespace {

IndexedMesh withFaces(IndexedMesh mesh, const std::vector<int>& faces) {
    mesh.F = mesh.F(faces, Eigen::all).eval();
    return mesh;
}

std::vector<int> facesBut(const IndexedMesh& mesh, int missing) {
    std::vector<int> faces;
    for (int f = 0; f < mesh.faceCount(); ++f)
        if (f != missing)
            faces.push_back(f);
    return faces;
}

IndexedMesh cornersOfTheirOwn(const IndexedMesh& mesh) {
    IndexedMesh soup = {Points(3 * mesh.faceCount(), 3), Triangles(mesh.faceCount(), 3)};
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k) {
            soup.V.row(3 * f + k) = mesh.V.row(mesh.F(f, k));
            soup.F(f, k) = 3 * f + k;
        }
    return soup;
}

void expectRefused(const IndexedMesh& mesh, const std::string& part) {
    const auto prepared = prepare(mesh, "part.stl");
    ASSERT_FALSE(prepared);
    EXPECT_EQ(prepared.error().code, ErrorCode::BadInput);
    EXPECT_NE(prepared.error().english().find(part), std::string::npos) << prepared.error().english();
    EXPECT_NE(prepared.error().english().find("part.stl"), std::string::npos);
}

IndexedMesh prepared(const IndexedMesh& mesh, const std::string& repair) {
    const auto done = prepare(mesh, "part.stl");
    EXPECT_TRUE(done) << done.error().english();
    if (!done)
        return {};
    std::string said;
    for (const Message& message : done->repairs)
        said += message.english();
    EXPECT_EQ(said, repair);
    EXPECT_TRUE(diagnose(done->mesh).usable());
    return done->mesh;
}

} // namespace

TEST(Diagnose, ASoundSphereAndRing) {
    const MeshDiagnosis sphere = diagnose(test::sphere({1, 2, 3}, 2, 2));
    EXPECT_TRUE(sphere.usable());
    EXPECT_EQ(sphere.genus, 0);
    EXPECT_EQ(sphere.components, 1);
    const MeshDiagnosis ring = diagnose(test::torus(3, 1, 20, 10));
    EXPECT_TRUE(ring.usable());
    EXPECT_EQ(ring.genus, 1);
    EXPECT_NEAR(ring.volume, volume(test::torus(3, 1, 20, 10)), 1e-12);
}

TEST(Diagnose, CountsHoles) {
    IndexedMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
    mesh = withFaces(mesh, {0, 1, 4, 5, 6, 7, 8, 9, 10, 11}); // the top is missing
    const MeshDiagnosis open = diagnose(mesh);
    EXPECT_FALSE(open.closed);
    EXPECT_TRUE(open.manifold);
    EXPECT_EQ(open.boundaryLoops, 1);
    EXPECT_EQ(open.openFaces.size(), 4U);
}

TEST(Diagnose, AnInsideOutSphereIsNotOriented) {
    IndexedMesh mesh = test::sphere({0, 0, 0}, 1, 1);
    mesh.F.col(1).swap(mesh.F.col(2));
    const MeshDiagnosis found = diagnose(mesh);
    EXPECT_TRUE(found.closed && found.manifold);
    EXPECT_FALSE(found.oriented);
    EXPECT_FALSE(found.usable());
}

TEST(SelfIntersections, TwoSpheresThatCross) {
    const auto crossing = test::together(test::sphere({0, 0, 0}, 1, 2), test::sphere({1, 0.1, 0.2}, 1, 2));
    EXPECT_FALSE(selfIntersections(crossing).empty());
    const auto apart = test::together(test::sphere({0, 0, 0}, 1, 2), test::sphere({2.1, 0, 0}, 1, 2));
    EXPECT_TRUE(selfIntersections(apart).empty());
}

TEST(SelfIntersections, BoxesThatOnlyTouchAreFound) {
    const auto touching =
        test::together(test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 0.25, 0.25}, {2, 0.5, 0.5}));
    EXPECT_FALSE(selfIntersections(touching).empty());
}

TEST(SelfIntersections, AFaceFoldedOntoItsNeighbour) {
    IndexedMesh fold = {Points(4, 3), Triangles(2, 3)};
    fold.V << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0.2, 0.5, 0;
    fold.F << 0, 1, 2, 1, 0, 3;
    EXPECT_EQ(selfIntersections(fold), (std::vector<std::pair<int, int>>{{0, 1}}));
    fold.V.row(3) << 0.2, -0.5, 0; // flat, but beside each other
    EXPECT_TRUE(selfIntersections(fold).empty());
    fold.V.row(3) << 0.2, 0.5, 1e-300; // the thinnest of wedges
    EXPECT_TRUE(selfIntersections(fold).empty());
}

TEST(SelfIntersections, FacesThatShareOnePointAndCross) {
    IndexedMesh pair = {Points(5, 3), Triangles(2, 3)};
    pair.V << 0, 0, 0, 2, -1, 0, 2, 1, 0, 1, 0, -1, 1, 0, 1;
    pair.F << 0, 1, 2, 0, 3, 4;
    EXPECT_EQ(selfIntersections(pair).size(), 1U);
    pair.V.row(3) << -1, 0, -1;
    pair.V.row(4) << -1, 0, 1;
    EXPECT_TRUE(selfIntersections(pair).empty());
}

TEST(SelfIntersections, AgreeWithTryingAllPairs) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> coordinate(0, 1);
    IndexedMesh soup = {Points(240, 3), Triangles(80, 3)};
    for (double& x : soup.V.reshaped())
        x = coordinate(random) * 0.4;
    for (int f = 0; f < 80; ++f)
        soup.F.row(f) << 3 * f, 3 * f + 1, 3 * f + 2;
    std::vector<std::pair<int, int>> one_by_one;
    for (int f = 0; f < 80; ++f)
        for (int g = f + 1; g < 80; ++g)
            if (!selfIntersections(withFaces(soup, {f, g})).empty())
                one_by_one.emplace_back(f, g);
    EXPECT_GT(one_by_one.size(), 50U);
    EXPECT_EQ(selfIntersections(soup), one_by_one);
}

TEST(Prepare, LeavesASoundMeshAsItIs) {
    const IndexedMesh mesh = test::torus(3, 1, 20, 10);
    const IndexedMesh same = prepared(mesh, "");
    EXPECT_EQ(same.V, mesh.V);
    EXPECT_EQ(same.F, mesh.F);
}

TEST(Prepare, WeldsEqualAndNearPoints) {
    const IndexedMesh sphere = test::sphere({0, 0, 0}, 1, 1);
    IndexedMesh soup = cornersOfTheirOwn(sphere);
    EXPECT_EQ(prepared(soup, "78 equal points were welded.").vertexCount(), 18);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> jitter(-2e-7, 2e-7);
    for (double& x : soup.V.reshaped())
        x += jitter(random);
    const IndexedMesh mended =
        prepared(soup, "78 points within a millionth of the size of each other were welded.");
    EXPECT_EQ(mended.vertexCount(), 18);
    EXPECT_NEAR(volume(mended), volume(sphere), 1e-5);
}

TEST(Prepare, TurnsFacesOutward) {
    IndexedMesh mesh = test::sphere({0, 0, 0}, 1, 1);
    const double outward = volume(mesh);
    for (const int f : {3, 4, 17})
        std::swap(mesh.F(f, 0), mesh.F(f, 1));
    EXPECT_DOUBLE_EQ(volume(prepared(mesh, "3 faces looked inward and were turned.")), outward);
    mesh = test::sphere({0, 0, 0}, 1, 1);
    mesh.F.col(0).swap(mesh.F.col(1));
    EXPECT_DOUBLE_EQ(volume(prepared(mesh, "The surface was inside out and was turned.")), outward);
}

TEST(Prepare, DropsWhatAddsNothing) {
    const IndexedMesh box = test::box({0, 0, 0}, {1, 2, 3});
    EXPECT_EQ(prepared(withFaces(box, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 3, 3}),
                       "2 repeated faces were removed.")
                  .faceCount(),
              12);
    IndexedMesh spare = test::together(box, box);
    spare.F.conservativeResize(12, Eigen::NoChange); // the second box's points are left over, far away
    spare.V.bottomRows(8).array() += 1e6;
    EXPECT_EQ(prepared(spare, "").vertexCount(), 8);
}

TEST(Prepare, JoinsBoxesBuiltWallToWall) {
    const auto wall = test::together(test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 0, 0}, {2, 1, 1}));
    const auto done = prepare(wall, "part.stl");
    ASSERT_TRUE(done) << done.error().english();
    EXPECT_EQ(done->mesh.faceCount(), 20);
    EXPECT_DOUBLE_EQ(volume(done->mesh), 2);
    EXPECT_EQ(done->repairs.size(), 2U);
}

TEST(Prepare, RefusesHolesAndSaysWhere) {
    const IndexedMesh mesh = test::box({0, 0, 0}, {3, 3, 3});
    const auto refused = prepare(withFaces(mesh, facesBut(mesh, 5)), "part.stl");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().english(),
              "The surface of part.stl has a hole, near (2, 1, 3), so it has no inside to "
              "cast. Close it in the program that made the file.");
    EXPECT_EQ(refused.error().faces.size(), 3U);
    EXPECT_EQ(refused.error().faces.size(), refused.error().places.size());
}

TEST(Prepare, RefusesWhatCannotBeCast) {
    const IndexedMesh ball = test::sphere({0, 0, 0}, 1, 2);
    expectRefused(test::together(ball, test::sphere({0.5, 0, 0}, 1, 2)), "crosses itself");
    expectRefused(test::together(test::sphere({0, 0, 0}, 3, 2), ball), "inside another");
    expectRefused(test::together(test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 0}, {2, 2, 1})),
                  "more than two faces");
    expectRefused(test::together(test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 1}, {2, 2, 2})),
                  "touches itself in a single point, at (1, 1, 1)");
    IndexedMesh flat = test::box({0, 0, 0}, {1, 1, 1});
    flat.V.col(2) *= 1e-14;
    expectRefused(flat, "no volume");
    IndexedMesh huge = ball;
    huge.V *= 1e200;
    expectRefused(huge, "No unit of length");
    expectRefused({}, "no faces");
}

TEST(Prepare, RefusesAOneSidedSurface) {
    // A Klein bottle as a grid: closing around the second time, the circle runs backwards.
    constexpr int n = 12;
    const auto at = [](int i, int j) { return (i % n) * n + ((i / n == 1 ? n - j % n : j) % n); };
    IndexedMesh bottle = {Points::Random(n * n, 3), Triangles(2 * n * n, 3)};
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            bottle.F.row(2 * (i * n + j)) << at(i, j), at(i + 1, j), at(i + 1, j + 1);
            bottle.F.row(2 * (i * n + j) + 1) << at(i, j), at(i + 1, j + 1), at(i, j + 1);
        }
    expectRefused(bottle, "only one side");
}

TEST(Prepare, KnowsNoUnit) {
    const IndexedMesh ring = test::torus(3, 1, 20, 10);
    for (const double scale : {1e-30, 1e-6, 1e6, 1e30}) {
        IndexedMesh scaled = ring;
        scaled.V *= scale;
        EXPECT_TRUE(prepare(scaled, "part.stl")) << scale;
    }
    IndexedMesh far = ring;
    far.V.array() += 1e9;
    EXPECT_TRUE(prepare(far, "part.stl"));
}

TEST(Prepare, AllowsSeveralSolidsAndSaysSo) {
    const auto two = test::together(test::sphere({0, 0, 0}, 1, 1), test::sphere({5, 0, 0}, 1, 1));
    const auto done = prepare(two, "part.stl");
    ASSERT_TRUE(done);
    ASSERT_EQ(done->notes.size(), 1U);
    EXPECT_EQ(done->notes[0].english(), "part.stl consists of 2 separate solids.");
}

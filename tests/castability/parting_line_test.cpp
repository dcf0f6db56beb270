// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/parting_line.h"

#include "castability/topology.h"
#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace moldwright;

namespace {

void expectParted(const PartedMesh& parted) {
    for (int f = 0; f < parted.mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k) {
            const double z = parted.mesh.corner(f, k).z();
            if (parted.labels[static_cast<std::size_t>(f)] == 1)
                EXPECT_GE(z, 0);
            else
                EXPECT_LE(z, 0);
        }
    // Every point of the line has one edge in and one out: the line is made of simple closed chains.
    std::map<int, int> in;
    std::map<int, int> out;
    for (const auto& [a, b] : partingEdges(parted.mesh, parted.labels)) {
        EXPECT_EQ(parted.mesh.V(a, 2), 0);
        ++out[a];
        ++in[b];
    }
    for (const auto& [v, count] : out) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(in[v], 1);
    }
}

} // namespace

TEST(PartingLine, KeepsShapeWithoutSnapping) {
    const IndexedMesh ball = test::sphere({0, 0, 0.013}, 1, 3);
    const PartedMesh parted = insertPartingLine(ball, 0);
    expectParted(parted);
    EXPECT_NEAR(volume(parted.mesh), volume(ball), 1e-12);
    EXPECT_NEAR(surfaceArea(parted.mesh), surfaceArea(ball), 1e-12);
    EXPECT_TRUE(topologyAllowsCasting(parted.mesh, parted.labels));
}

TEST(PartingLine, SnappingAvoidsSlivers) {
    const IndexedMesh ball = test::rotated(test::sphere({0, 0, 0.001}, 1, 4), {0.6, 0, 0.8}, 0.3);
    const auto smallest = [](const IndexedMesh& mesh) {
        double area = 1;
        for (int f = 0; f < mesh.faceCount(); ++f)
            area = std::min(area, doubleAreaVector(mesh, f).norm());
        return area;
    };
    const PartedMesh plain = insertPartingLine(ball, 0);
    const PartedMesh snapped = insertPartingLine(ball, 0.25);
    expectParted(snapped);
    EXPECT_GT(smallest(snapped.mesh), 10 * smallest(plain.mesh));
    EXPECT_NEAR(volume(snapped.mesh), volume(ball), 0.01);
}

TEST(PartingLine, EveryFaceKnowsItsSource) {
    const IndexedMesh ball = test::sphere({0, 0, 0.1}, 1, 2);
    const PartedMesh parted = insertPartingLine(ball, 0);
    for (int f = 0; f < parted.mesh.faceCount(); ++f) {
        const Eigen::Vector3d middle =
            (parted.mesh.corner(f, 0) + parted.mesh.corner(f, 1) + parted.mesh.corner(f, 2)) / 3;
        const int source = parted.sourceFace[static_cast<std::size_t>(f)];
        const Eigen::Vector3d N = doubleAreaVector(ball, source).normalized();
        EXPECT_NEAR(N.dot(middle - ball.corner(source, 0)), 0, 1e-12);
    }
}

TEST(PartingLine, AFlatBackStaysFlatAndIsSideTwo) {
    const IndexedMesh box = test::splitInFour(test::splitInFour(test::box({-1, -1, 0}, {1, 1, 1})));
    const PartedMesh parted = insertPartingLine(box, 0.25);
    expectParted(parted);
    EXPECT_EQ(parted.mesh.V, box.V);
    int below = 0;
    for (int f = 0; f < parted.mesh.faceCount(); ++f)
        below += parted.labels[static_cast<std::size_t>(f)] == 2;
    EXPECT_EQ(below, 2 * 16);
    EXPECT_TRUE(topologyAllowsCasting(parted.mesh, parted.labels));
}

TEST(PartingLine, TouchesAndPinchesAreLoosened) {
    // Two pyramids that meet the plane from above and below in one point each, on one body: a saddle of
    // points.
    IndexedMesh mesh = test::splitInFour(test::splitInFour(test::box({-1, -1, -1}, {1, 1, 1})));
    for (int v = 0; v < mesh.vertexCount(); ++v)
        mesh.V(v, 2) += 0.7 * mesh.V(v, 0) * mesh.V(v, 1); // z = 0 meets the sides in crossing lines
    expectParted(insertPartingLine(mesh, 0.25));
    expectParted(insertPartingLine(mesh, 0.02));
}

TEST(Topology, ATorusLyingIsCastableStandingItIsAnArch) {
    const IndexedMesh lying = test::torus(2, 0.5, 48, 24);
    IndexedMesh tilted = lying;
    tilted.V.col(2).array() += 0.01;
    const PartedMesh flat = insertPartingLine(tilted, 0.25);
    EXPECT_TRUE(topologyAllowsCasting(flat.mesh, flat.labels));
    for (const SidePiece& piece : sidePieces(flat.mesh, flat.labels)) {
        EXPECT_EQ(piece.genus, 0);
        EXPECT_EQ(piece.loops.size(), 2U);
    }

    IndexedMesh standing = test::rotated(lying, Eigen::Vector3d::UnitX(), std::numbers::pi / 2);
    standing.V.col(2).array() += 0.013;
    const PartedMesh parted = insertPartingLine(standing, 0.25);
    std::vector<PieceFault> faults;
    for (const SidePiece& piece : sidePieces(parted.mesh, parted.labels))
        faults.push_back(pieceFault(parted.mesh, piece));
    EXPECT_EQ(faults, (std::vector{PieceFault::Arch, PieceFault::Arch}));

    standing.V.col(2).array() += 2.2; // the hole wholly above the plane
    const PartedMesh high = insertPartingLine(standing, 0.25);
    EXPECT_EQ(pieceFault(high.mesh, sidePieces(high.mesh, high.labels).front()), PieceFault::Handle);
}

TEST(Topology, AComponentOffThePlaneIsClosed) {
    const IndexedMesh two = test::together(test::sphere({0, 0, 0.01}, 1, 3), test::sphere({0, 0, 3}, 1, 3));
    const PartedMesh parted = insertPartingLine(two, 0.25);
    EXPECT_FALSE(topologyAllowsCasting(parted.mesh, parted.labels));
    const auto pieces = sidePieces(parted.mesh, parted.labels);
    EXPECT_EQ(
        std::count_if(pieces.begin(), pieces.end(),
                      [&](const SidePiece& p) { return pieceFault(parted.mesh, p) == PieceFault::Closed; }),
        1);
}

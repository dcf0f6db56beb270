// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/clean_up.h"

#include "deformation/labelled_shapes.h"
#include "deformation/side_hinge.h"
#include "mesh/measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

using namespace moldwright;

namespace {

const double kTau = std::sin(radians(1));

double worstSine(const LabelledSurface& surface) {
    return sideDraft(surface.mesh.F, surface.labels, {}, surface.mesh.V, kTau).worstSine;
}

double shortestEdge(const IndexedMesh& mesh) {
    double shortest = std::numeric_limits<double>::infinity();
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            shortest = std::min(shortest, (mesh.corner(f, k) - mesh.corner(f, (k + 1) % 3)).norm());
    return shortest;
}

/// A neighbour of v off the parting line.
int neighbourOf(const LabelledSurface& surface, int v) {
    const Triangles& F = surface.mesh.F;
    for (int f = 0; f < surface.mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            if (F(f, k) == v && surface.mesh.V(F(f, (k + 1) % 3), 2) != 0)
                return F(f, (k + 1) % 3);
    return -1;
}

int pointNear(const LabelledSurface& surface, const Eigen::RowVector3d& place) {
    Eigen::Index nearest = 0;
    (surface.mesh.V.rowwise() - place).rowwise().squaredNorm().minCoeff(&nearest);
    return static_cast<int>(nearest);
}

void expectSound(const LabelledSurface& surface, const LabelledSurface& before) {
    EXPECT_TRUE(test::soundlyParted(surface));
    EXPECT_EQ(surface.labels.size(), static_cast<std::size_t>(surface.mesh.faceCount()));
    EXPECT_EQ(surface.sourceVertex.size(), static_cast<std::size_t>(surface.mesh.vertexCount()));
    int unmoved = 0;
    for (int v = 0; v < surface.mesh.vertexCount(); ++v)
        unmoved +=
            surface.mesh.V.row(v) == before.mesh.V.row(surface.sourceVertex[static_cast<std::size_t>(v)]);
    EXPECT_GT(unmoved, surface.mesh.vertexCount() / 2);
    const std::set<int> sources(surface.sourceVertex.begin(), surface.sourceVertex.end());
    EXPECT_EQ(sources.size(), surface.sourceVertex.size()) << "no point comes from two";
    EXPECT_GE(worstSine(surface), worstSine(before));
}

/// A point pushed over its neighbour: the faces between them are folded over.
LabelledSurface ballWithAFold() {
    LabelledSurface surface = test::labelledBall(3);
    const int v = pointNear(surface, {0.3, 0.1, 0.4});
    const int u = neighbourOf(surface, v);
    surface.mesh.V.row(v) += 1.3 * (surface.mesh.V.row(u) - surface.mesh.V.row(v));
    return surface;
}

/// A point pushed nearly onto its neighbour: two needles between them.
LabelledSurface ballWithNeedles() {
    LabelledSurface surface = test::labelledBall(3);
    const int v = pointNear(surface, {0.3, -0.2, -0.35});
    const int u = neighbourOf(surface, v);
    surface.mesh.V.row(v) += 0.999 * (surface.mesh.V.row(u) - surface.mesh.V.row(v));
    return surface;
}

} // namespace

TEST(CleanUp, LeavesASoundSurfaceAlone) {
    LabelledSurface surface = test::labelledBall(3);
    const LabelledSurface before = surface;
    EXPECT_EQ(cleanUp(surface, {{}, kTau, 1e-3, 1e-3}), 0);
    EXPECT_EQ(surface.mesh.V, before.mesh.V);
    EXPECT_EQ(surface.mesh.F, before.mesh.F);
    EXPECT_EQ(surface.labels, before.labels);
}

TEST(CleanUp, MendsAFold) {
    const LabelledSurface before = ballWithAFold();
    ASSERT_LT(worstSine(before), 0);
    LabelledSurface surface = before;
    EXPECT_GT(cleanUp(surface, {{}, kTau, 0, 0}), 0);
    expectSound(surface, before);
    EXPECT_GT(worstSine(surface), kTau);
}

TEST(CleanUp, CollapsesTheShortAndTheThin) {
    const LabelledSurface before = ballWithNeedles();
    LabelledSurface surface = before;
    ASSERT_LT(shortestEdge(before.mesh), 1e-3);
    EXPECT_GT(cleanUp(surface, {{}, kTau, 1e-3, 1e-3}), 0);
    expectSound(surface, before);
    EXPECT_GT(shortestEdge(surface.mesh), 1e-3);
    EXPECT_LT(surface.mesh.vertexCount(), before.mesh.vertexCount());
    EXPECT_NEAR(volume(surface.mesh), volume(before.mesh), 0.01 * volume(before.mesh));
}

TEST(CleanUp, KeepsTheSurfaceSoundHoweverShaken) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
        LabelledSurface surface = test::labelledBall(3);
        std::srand(seed); // of Eigen's Random()
        Points shake = 0.02 * Points::Random(surface.mesh.V.rows(), 3);
        for (int v = 0; v < surface.mesh.vertexCount(); ++v) {
            if (surface.mesh.V(v, 2) == 0)
                shake(v, 2) = 0;
            else if (std::abs(surface.mesh.V(v, 2)) < 0.03)
                shake.row(v).setZero();
        }
        surface.mesh.V += shake;
        ASSERT_TRUE(test::soundlyParted(surface));
        const LabelledSurface before = surface;
        EXPECT_GT(cleanUp(surface, {{}, std::sin(radians(3)), 0.01, 0.01}), 0);
        expectSound(surface, before);
    }
}

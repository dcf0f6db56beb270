// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/dislodge.h"

#include "deformation/labelled_shapes.h"
#include "deformation/side_hinge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

using namespace moldwright;

namespace {

const double kTau = std::sin(radians(1));

/// All points pushed about at random, each on its side, those of the parting line within the plane.
LabelledSurface shakenBall(unsigned seed, double by) {
    LabelledSurface surface = test::labelledBall(3);
    std::srand(seed); // of Eigen's Random()
    Points shake = by * Points::Random(surface.mesh.V.rows(), 3);
    for (int v = 0; v < surface.mesh.vertexCount(); ++v) {
        const double most = std::abs(surface.mesh.V(v, 2)) / 2;
        shake(v, 2) = std::clamp(shake(v, 2), -most, most);
    }
    surface.mesh.V += shake;
    return surface;
}

int facesShort(const LabelledSurface& surface) {
    return sideDraft(surface.mesh.F, surface.labels, {}, surface.mesh.V, kTau).violating;
}

} // namespace

TEST(Dislodge, FreesWhatNoSingleChangeFrees) {
    const CleanUpGoal goal{{}, kTau, 0, 0};
    int stuckBefore = 0;
    int stuckAfter = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        LabelledSurface surface = shakenBall(seed, 0.05);
        if (!test::soundlyParted(surface))
            continue;
        while (cleanUp(surface, goal) > 0)
            ;
        const LabelledSurface before = surface;
        const int changes = dislodge(surface, goal);
        EXPECT_EQ(changes > 0, facesShort(surface) < facesShort(before));
        EXPECT_TRUE(test::soundlyParted(surface));
        stuckBefore += facesShort(before);
        stuckAfter += facesShort(surface);
    }
    EXPECT_GT(stuckBefore, 2);
    EXPECT_LT(2 * stuckAfter, stuckBefore);
}

TEST(Dislodge, LeavesASoundSurfaceAlone) {
    LabelledSurface surface = test::labelledBall(3);
    EXPECT_EQ(dislodge(surface, {{}, kTau, 0, 0}), 0);
}

TEST(Dislodge, TakesAwayAFinOfNoThickness) {
    LabelledSurface surface = test::finInThePlane();
    ASSERT_EQ(facesShort(surface), 0);
    ASSERT_EQ(countFolds(surface), 2);
    EXPECT_GT(dislodge(surface, {{}, kTau, 0, 0}), 0);
    EXPECT_EQ(countFolds(surface), 0);
    EXPECT_EQ(facesShort(surface), 0);
    EXPECT_TRUE(test::soundlyParted(surface));
}

TEST(LabelledPatch, IsACopyWhoseRimStays) {
    LabelledMesh whole(test::labelledBall(4));
    const LabelledMesh::Vertex centre(0);
    const std::optional<LabelledPatch> patch = whole.patchAbout(centre, 3);
    ASSERT_TRUE(patch);
    const TriangleMesh& topology = patch->mesh.topology();
    ASSERT_LT(topology.n_vertices(), whole.topology().n_vertices());
    EXPECT_EQ(topology.n_faces(), whole.facesAbout(centre, 3).size());
    EXPECT_FALSE(patch->mesh.onRim(patch->at(centre)));
    LabelledMesh copy = patch->mesh;
    int rim = 0;
    for (const auto v : topology.vertices()) {
        const LabelledMesh::Vertex origin = patch->origin[static_cast<std::size_t>(v.idx())];
        EXPECT_EQ(patch->mesh.point(v), whole.point(origin));
        EXPECT_EQ(patch->at(origin), v);
        rim += copy.onRim(v);
        for (const auto h : topology.voh_range(v))
            EXPECT_FALSE(copy.onRim(v) && copy.mayCollapse(h));
    }
    EXPECT_GT(rim, 6);
}

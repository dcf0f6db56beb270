// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/finish.h"

#include "castability/certificate.h"
#include "deformation/labelled_shapes.h"
#include "deformation/side_hinge.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

/// A ball that bulges away from the plane: undercut near the plane on both sides.
LabelledSurface bulgingBall() {
    LabelledSurface surface = test::labelledBall(4);
    for (int v = 0; v < surface.mesh.vertexCount(); ++v) {
        const double z = std::abs(surface.mesh.V(v, 2));
        surface.mesh.V.row(v).head<2>() *= 1 + 2 * z * (1 - z);
    }
    return surface;
}

int violations(const LabelledSurface& surface, double draftDegrees) {
    return sideDraft(surface.mesh.F, surface.labels, {}, surface.mesh.V, std::sin(radians(draftDegrees)))
        .violating;
}

} // namespace

TEST(Finish, BringsASlightlyUndercutShapeToAProvedDraft) {
    LabelledSurface surface = bulgingBall();
    const Points before = surface.mesh.V;
    ASSERT_GT(violations(surface, 1), 20);
    int rounds = 0;
    EXPECT_TRUE(finishSurface(surface, {{}, 1, 1e-7, 10}, {}, [&](const LabelledSurface&) { ++rounds; }));
    EXPECT_GT(rounds, 0);
    EXPECT_TRUE(test::soundlyParted(surface));
    EXPECT_EQ(violations(surface, 1), 0);
    const Certificate proof = certify(surface.mesh, surface.labels, {}, 1);
    EXPECT_TRUE(proof.holds()) << proof.reason;
    double motion = 0;
    for (int v = 0; v < surface.mesh.vertexCount(); ++v)
        motion +=
            (surface.mesh.V.row(v) - before.row(surface.sourceVertex[static_cast<std::size_t>(v)])).norm();
    EXPECT_LT(motion / surface.mesh.vertexCount(), 0.02);
}

TEST(Finish, LeavesWhatHasItsDraftAsItIs) {
    LabelledSurface surface = test::labelledBall(2);
    const Points before = surface.mesh.V;
    EXPECT_TRUE(finishSurface(surface, {{}, 1, 1e-7, 10}, {}, {}));
    EXPECT_EQ(surface.mesh.V, before);
}

TEST(Finish, SaysSoWhenItCannot) {
    LabelledSurface surface = bulgingBall();
    for (std::uint8_t& label : surface.labels)
        label = 3 - label; // every face on the wrong side
    EXPECT_FALSE(finishSurface(surface, {{}, 1, 1e-7, 2}, {}, {}));
}

TEST(Finish, EndsEarlyWhenCancelled) {
    LabelledSurface surface = bulgingBall();
    const Task task;
    task.cancel();
    EXPECT_FALSE(finishSurface(surface, {{}, 1, 1e-7, 10}, task, {}));
}

TEST(Finish, LeavesNothingFoldedInThePlane) {
    LabelledSurface surface = test::finInThePlane();
    EXPECT_TRUE(finishSurface(surface, {{}, 1, 1e-7, 10}, {}, {}));
    EXPECT_EQ(countFolds(surface), 0);
}

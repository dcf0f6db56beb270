// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/float_rounding.h"

#include "castability/certificate.h"
#include "support/casts.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moldwright;
using namespace moldwright::test;

namespace {

/// A frustum pair with one point added on a top edge of the walls, next to a corner: a sliver along a
/// diagonal, which rounding turns towards the vertical.
KnownCast withSliver(double x, double angle) {
    KnownCast cast = frusta(20, 10, 5, 3, 0.1);
    IndexedMesh& mesh = cast.mesh;
    // Points 4 and 5 are the rectangle's corners in the plane, front; 8 and 9 those of the top.
    const int added = mesh.vertexCount();
    mesh.V.conservativeResize(added + 1, 3);
    mesh.V.row(added) = mesh.V.row(9) + x * (mesh.V.row(8) - mesh.V.row(9));
    Triangles faces(mesh.faceCount() + 2, 3);
    Eigen::Index next = 0;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        Eigen::RowVector3i face = mesh.F.row(f);
        for (int k = 0; k < 3; ++k) {
            const int from = face[k];
            const int to = face[(k + 1) % 3];
            const int opposite = face[(k + 2) % 3];
            if (!((from == 8 && to == 9) || (from == 9 && to == 8)))
                continue;
            faces.row(next++) << added, to, opposite;
            face << from, added, opposite;
            break;
        }
        faces.row(next++) = face;
    }
    mesh.F = faces;
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
    mesh.V = mesh.V * R.transpose();
    cast.state.plane.normal = R * cast.state.plane.normal;
    cast.state.directions = Directions::normalTo(cast.state.plane);
    return cast;
}

} // namespace

TEST(FloatRounding, GivesFloatsAndKeepsWhatIsOne) {
    KnownCast cast = ball(10, 3);
    const SideLabels labels = labelSides(cast.mesh, cast.state.plane);
    const IndexedMesh rounded = roundKeepingDraft(cast.mesh, labels, cast.state.directions, 1);
    EXPECT_EQ(rounded.V, rounded.V.cast<float>().cast<double>());
    EXPECT_LT((rounded.V - cast.mesh.V).cwiseAbs().maxCoeff(), 1e-6);
    for (int v = 0; v < rounded.vertexCount(); ++v)
        if (cast.mesh.V(v, 2) == 0) {
            EXPECT_EQ(rounded.V(v, 2), 0);
        }
}

TEST(FloatRounding, MendsSliversThatRoundingTurned) {
    int turned = 0;
    int mended = 0;
    for (int i = 1; i <= 40; ++i) {
        const KnownCast cast = withSliver(1e-7, 0.1 * i);
        const SideLabels labels = labelSides(cast.mesh, cast.state.plane);
        IndexedMesh nearest = cast.mesh;
        nearest.V = nearest.V.cast<float>().cast<double>();
        const IndexedMesh rounded = roundKeepingDraft(cast.mesh, labels, cast.state.directions, 5);
        const auto below = [&](const IndexedMesh& mesh) {
            return certify(mesh, labels, cast.state, 5).violatingFaces.size();
        };
        ASSERT_EQ(below(cast.mesh), 0U);
        turned += below(nearest) > 0 ? 1 : 0;
        mended += below(nearest) > 0 && below(rounded) == 0 ? 1 : 0;
        EXPECT_LE(below(rounded), below(nearest));
    }
    EXPECT_GT(turned, 10);
    EXPECT_EQ(mended, turned);
}

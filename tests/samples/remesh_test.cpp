// SPDX-License-Identifier: AGPL-3.0-or-later
#include "remesh.h"

#include "base/parallel.h"
#include "mesh/check.h"
#include "mesh/measures.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::samples;

namespace {

const Solid dome = {ball({0, 0, 1}, 5), {Vector3d(-7, -7, -7), Vector3d(7, 7, 7)}, true};
const Fineness fine = {0.4, 1, 0.02};

IndexedMesh remeshed(const Solid& solid) {
    return remesh(contour(solid, fine.shortest), solid, fine);
}

} // namespace

TEST(Remesh, DrawsEveryPointOntoTheSurfaceAndKeepsTheBackFlat) {
    const IndexedMesh mesh = remeshed(dome);
    EXPECT_TRUE(diagnose(mesh).usable());
    int onBack = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const double off = dome.field(mesh.point(v));
        if (mesh.point(v).z() == 0) {
            ++onBack;
            EXPECT_LT(off, 1e-3);
        } else {
            EXPECT_GT(mesh.point(v).z(), 0);
            EXPECT_NEAR(off, 0, 1e-3);
        }
    }
    EXPECT_GT(onBack, 50);
}

TEST(Remesh, LengthsFollowTheCurvature) {
    const Field large = ball({0, 0, 0}, 5);
    const Field small = ball({5.5, 0, 0}, 1);
    const Solid solid = {join({large, small}, 0.5), {Vector3d(-7, -7, -7), Vector3d(8, 7, 7)}};
    const IndexedMesh mesh = remeshed(solid);
    double farArea = 0, nearArea = 0;
    int farFaces = 0, nearFaces = 0;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const double area = doubleAreaVector(mesh, f).norm() / 2;
        const double x = mesh.corner(f, 0).x();
        (x > 5.5 ? nearArea : farArea) += x > 5.5 || x < 0 ? area : 0;
        (x > 5.5 ? nearFaces : farFaces) += x > 5.5 || x < 0 ? 1 : 0;
    }
    EXPECT_LT(nearArea / nearFaces, 0.6 * farArea / farFaces);
}

TEST(Remesh, ThreadsDoNotMatter) {
    setThreadCount(1);
    const IndexedMesh one = remeshed(dome);
    setThreadCount(3);
    const IndexedMesh three = remeshed(dome);
    setThreadCount(0);
    EXPECT_EQ(one.V, three.V);
    EXPECT_EQ(one.F, three.F);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "contour.h"

#include "mesh/check.h"
#include "mesh/measures.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace moldwright;
using namespace moldwright::samples;

namespace {

const Eigen::AlignedBox3d cube(Vector3d(-7, -7, -7), Vector3d(7, 7, 7));

} // namespace

TEST(Contour, BallIsClosedOutwardAndOfItsVolume) {
    const IndexedMesh mesh = contour({ball({0, 0, 0}, 5), cube}, 0.5);
    const MeshDiagnosis diagnosis = diagnose(mesh);
    EXPECT_TRUE(diagnosis.usable());
    EXPECT_EQ(diagnosis.genus, 0);
    EXPECT_NEAR(volume(mesh), 4.0 / 3 * std::numbers::pi * 125, 6);
}

TEST(Contour, TopologyFollowsTheField) {
    const Field ring = [](const Vector3d& p) {
        return std::hypot(std::hypot(p.x(), p.y()) - 4, p.z()) - 1.5;
    };
    EXPECT_EQ(diagnose(contour({ring, cube}, 0.5)).genus, 1);
    const Field two = join({ball({-3, 0, 0}, 2), ball({3, 0, 0}, 2)}, 0);
    EXPECT_EQ(diagnose(contour({two, cube}, 0.5)).components, 2);
}

TEST(Contour, FlatBackLiesExactlyInItsPlane) {
    const IndexedMesh dome = contour({ball({0, 0, 1}, 5), cube, true}, 0.5);
    EXPECT_TRUE(diagnose(dome).usable());
    EXPECT_EQ(boundingBox(dome).min().z(), 0);
    double back = 0;
    for (int f = 0; f < dome.faceCount(); ++f)
        if (dome.corner(f, 0).z() == 0 && dome.corner(f, 1).z() == 0 && dome.corner(f, 2).z() == 0)
            back -= doubleAreaVector(dome, f).z() / 2;
    EXPECT_NEAR(back, std::numbers::pi * 24, 1.5);
}

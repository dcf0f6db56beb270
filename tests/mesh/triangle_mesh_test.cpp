// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/triangle_mesh.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;

TEST(TriangleMesh, RoundTripKeepsIndicesAndCorners) {
    const IndexedMesh sphere = test::sphere({1, 2, 3}, 4, 2);
    const IndexedMesh back = toIndexedMesh(toTriangleMesh(sphere));
    EXPECT_EQ(back.V, sphere.V);
    ASSERT_EQ(back.faceCount(), sphere.faceCount());
    for (int f = 0; f < back.faceCount(); ++f) {
        // OpenMesh may start a face at another corner; the cycle must be the same.
        const Eigen::RowVector3i a = sphere.F.row(f);
        const Eigen::RowVector3i b = back.F.row(f);
        const int shift = b[0] == a[0] ? 0 : b[0] == a[1] ? 1 : 2;
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(b[k], a[(k + shift) % 3]);
    }
}

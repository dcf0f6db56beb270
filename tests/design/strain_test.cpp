// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/strain.h"

#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace moldwright;

namespace {

std::vector<int> same(const IndexedMesh& mesh) {
    std::vector<int> source(static_cast<std::size_t>(mesh.vertexCount()));
    std::iota(source.begin(), source.end(), 0);
    return source;
}

} // namespace

TEST(Strain, ARigidMotionStrainsNothing) {
    const IndexedMesh ball = test::sphere({1, 2, 3}, 5, 2);
    const IndexedMesh turned = test::rotated(ball, Eigen::Vector3d(1, 2, 2).normalized(), 0.7);
    const SurfaceStrain strain = surfaceStrain(ball, turned, same(ball));
    EXPECT_NEAR(strain.rms, 0, 1e-12);
    EXPECT_NEAR(strain.stretchLow, 1, 1e-12);
    EXPECT_NEAR(strain.stretchHigh, 1, 1e-12);
    EXPECT_NEAR(strain.roughness, 1, 1e-12);
}

TEST(Strain, AScaledShapeIsStretchedAlikeEverywhere) {
    const IndexedMesh ball = test::sphere({0, 0, 0}, 5, 2);
    IndexedMesh larger = ball;
    larger.V *= 1.1;
    const SurfaceStrain strain = surfaceStrain(ball, larger, same(ball));
    EXPECT_NEAR(strain.rms, std::sqrt(2 * 0.1 * 0.1), 1e-12);
    EXPECT_NEAR(strain.stretchLow, 1.1, 1e-12);
    EXPECT_NEAR(strain.stretchHigh, 1.1, 1e-12);
}

TEST(Strain, AStretchedBoxShowsBothPrincipalStretches) {
    const IndexedMesh box = test::splitInFour(test::box({0, 0, 0}, {1, 1, 1}));
    IndexedMesh longer = box;
    longer.V.col(0) *= 2;
    const SurfaceStrain strain = surfaceStrain(box, longer, same(box));
    EXPECT_NEAR(strain.stretchHigh, 2, 1e-12);
    EXPECT_NEAR(strain.stretchLow, 1, 1e-12);
    EXPECT_NEAR(strain.rms, std::sqrt(4.0 / 6.0), 1e-12) << "four of six sides are twice as long one way";
}

TEST(Strain, EachFaceTellsItsOwn) {
    const IndexedMesh box = test::box({0, 0, 0}, {1, 1, 1});
    IndexedMesh longer = box;
    longer.V.col(0) *= 2;
    const std::vector<double> strains = faceStrains(box.V, longer);
    ASSERT_EQ(strains.size(), 12U);
    for (int f = 0; f < 12; ++f) {
        const bool across = std::abs(doubleAreaVector(box, f).normalized().x()) > 0.5;
        EXPECT_NEAR(strains[static_cast<std::size_t>(f)], across ? 0 : 1, 1e-12) << f;
    }
    Points flat = box.V;
    flat.row(box.F(0, 1)) = flat.row(box.F(0, 0));
    EXPECT_EQ(faceStrains(flat, longer)[0], 0) << "a face without area before";
}

TEST(Strain, NeedlesTellNothingOfTheShape) {
    // A square's diagonal has a point on it, all but: the needle between them opens a little.
    IndexedMesh square{Points(5, 3), Triangles(4, 3)};
    square.V << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5 - 1e-9, 0;
    square.F << 0, 1, 4, 1, 2, 4, 0, 4, 2, 0, 2, 3;
    IndexedMesh opened = square;
    opened.V(4, 1) = 0.49;
    const SurfaceStrain strain = surfaceStrain(square, opened, same(square));
    EXPECT_GT(strain.rms, 0.001);
    EXPECT_LT(strain.rms, 0.1);
}

TEST(Strain, ADentMakesTheSurfaceRougher) {
    const IndexedMesh ball = test::sphere({0, 0, 0}, 5, 3);
    IndexedMesh dented = ball;
    dented.V.row(7) *= 0.8;
    EXPECT_GT(surfaceStrain(ball, dented, same(ball)).roughness, 1.1);
}

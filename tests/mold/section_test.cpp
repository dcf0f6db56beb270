// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/section.h"

#include "mesh/measures.h"
#include "mold/mold.h"
#include "support/casts.h"
#include "support/molds.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace moldwright;
using Eigen::Vector3d;

namespace {

constexpr double pi = std::numbers::pi;

PartingPlane level(double height) {
    return {Vector3d::UnitZ(), height};
}

/// Whether every triangle lies in the plane and faces along its normal.
bool facesAlong(const Section& section, const PartingPlane& cut) {
    for (int f = 0; f < section.fill.faceCount(); ++f)
        if (doubleAreaVector(section.fill, f).dot(cut.normal) <= 0)
            return false;
    return ((section.fill.V * cut.normal).array() - cut.offset).abs().maxCoeff() < 1e-5;
}

} // namespace

TEST(Section, OfABoxIsItsFace) {
    const IndexedMesh box = test::box({0, 0, 0}, {2, 3, 4});
    const Section section = sectionOf(box, level(1));
    EXPECT_NEAR(section.area, 6, 1e-12);
    EXPECT_TRUE(facesAlong(section, level(1)));
    EXPECT_EQ(sectionOf(box, level(5)).fill.faceCount(), 0);
    EXPECT_EQ(sectionOf(box, level(-1)).fill.faceCount(), 0);
}

TEST(Section, AtAFaceOfASolidItIsFullFromInsideAndEmptyFromOutside) {
    const IndexedMesh box = test::box({0, 0, 0}, {2, 3, 4});
    EXPECT_NEAR(sectionOf(box, level(4)).area, 6, 1e-9) << "the box lies behind";
    EXPECT_EQ(sectionOf(box, level(0)).area, 0) << "nothing lies behind";
    EXPECT_NEAR(sectionOf(box, {-Vector3d::UnitZ(), 0}).area, 6, 1e-9);
}

TEST(Section, HasHolesWhereTheSolidHasThem) {
    const IndexedMesh ring = test::torus(10, 3, 200, 100);
    const Section across = sectionOf(ring, level(0));
    EXPECT_NEAR(across.area, pi * (13 * 13 - 7 * 7), 0.002 * across.area) << "points lie in the plane";
    const Section upright = sectionOf(ring, {Vector3d(1, 0.3, 0).normalized(), 0.01});
    EXPECT_NEAR(upright.area, 2 * pi * 9, 0.002 * upright.area) << "two discs";
    IndexedMesh hollow = test::sphere({0, 0, 0}, 5, 4);
    IndexedMesh inside = test::sphere({0, 0, 0}, 3, 4);
    inside.F.col(1).swap(inside.F.col(2));
    hollow = test::together(hollow, inside);
    EXPECT_NEAR(sectionOf(hollow, level(0.5)).area, pi * (25 - 9), 0.02 * pi * 25);
}

TEST(Section, TakesPointsAHairOffThePlaneAsInIt) {
    test::KnownCast cast = test::moved(test::frusta(20, 10, 5, 3, 0.1), {1, 2, 3}, 0.5, {1, 2, 3});
    for (const Vector3d& normal : {cast.state.plane.normal, Vector3d(-cast.state.plane.normal)}) {
        const PartingPlane cut{normal, normal.dot(cast.state.plane.offset * cast.state.plane.normal)};
        EXPECT_NEAR(sectionOf(cast.mesh, cut).area, 200, 1e-3);
    }
}

TEST(Section, OfBothHalvesAndTheCastFillsTheBlock) {
    const test::KnownCast cast = test::frusta(20, 10, 5, 3, 0.1);
    const Result<Mold> mold = buildMold(test::trayOf(cast), 1, MoldSettings{});
    ASSERT_TRUE(mold);
    const PartingPlane upright{Vector3d(0.8, 0.6, 0), 0.3};
    const double halves =
        sectionOf(*mold->half1.mesh, upright).area + sectionOf(*mold->half2.mesh, upright).area;
    const Eigen::AlignedBox3d box = boundingBox(*mold->half1.mesh).merged(boundingBox(*mold->half2.mesh));
    const double block = sectionOf(test::box(box.min(), box.max()), upright).area;
    EXPECT_NEAR(halves + sectionOf(*mold->cast, upright).area, block, 1e-4 * block);
    // At the parting plane each half ends in the block's face without the cavity.
    const double face = box.sizes().x() * box.sizes().y();
    EXPECT_NEAR(sectionOf(*mold->half2.mesh, level(0)).area, face - 200, 1e-3);
}

TEST(Section, OfManySlantedPlanesFitsTheVolume) {
    const IndexedMesh ring = test::torus(10, 3, 60, 40);
    const Vector3d normal = Vector3d(1, 2, 4).normalized();
    constexpr int slices = 400;
    const double low = (ring.V * normal).minCoeff();
    const double step = ((ring.V * normal).maxCoeff() - low) / slices;
    double sum = 0;
    for (int i = 0; i < slices; ++i)
        sum += step * sectionOf(ring, {normal, low + (i + 0.5) * step}).area;
    EXPECT_NEAR(sum, volume(ring), 1e-4 * volume(ring));
}

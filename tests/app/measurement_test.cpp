// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/measurement.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;
using Eigen::Vector3d;

namespace {

const SharedMesh box = std::make_shared<const IndexedMesh>(test::box({0, 0, 0}, {1, 1, 1}));

MeasuredPoint at(double x, double y, double z) {
    return {.place = Vector3d(x, y, z)};
}

} // namespace

TEST(Measurement, TwoPlacesGiveADistanceAndThreeAnAngle) {
    Measurement measured;
    EXPECT_TRUE(measured.empty());
    measured.add(box, at(3, 0, 0));
    EXPECT_FALSE(measured.distance());
    measured.add(box, at(0, 0, 0));
    EXPECT_NEAR(*measured.distance(), 3, 1e-12);
    EXPECT_FALSE(measured.angleDegrees());
    measured.add(box, at(0, 5, 5));
    EXPECT_NEAR(*measured.angleDegrees(), 90, 1e-12);
    EXPECT_NEAR(*measured.distance(), 3, 1e-12);
    EXPECT_EQ(measured.path().size(), 3U);
}

TEST(Measurement, AFourthPlaceOrAnotherSurfaceBeginsAnew) {
    Measurement measured;
    for (int i = 0; i < 4; ++i)
        measured.add(box, at(i, 0, 0));
    EXPECT_EQ(measured.path().size(), 1U);
    const SharedMesh other = std::make_shared<const IndexedMesh>(*box);
    measured.add(other, at(0, 0, 0));
    EXPECT_EQ(measured.path().size(), 1U);
    EXPECT_TRUE(measured.isOf(other));
    EXPECT_FALSE(measured.isOf(box));
}

TEST(Measurement, TheTextHoldsAllThatTheChipsTell) {
    Measurement measured;
    MeasuredPoint first = at(-1.5, 0, 0);
    first.draftDegrees = -3.2;
    first.thickness = 4;
    measured.add(box, first);
    measured.add(box, at(0, 2, 0));
    const QString text = measured.text();
    for (const char* part :
         {"Point 1: −1.50  0.00  0.00 mm", "Draft −3.2°", "thickness 4.00 mm", "Distance: 2.50 mm", "y 2.00"})
        EXPECT_TRUE(text.contains(QString::fromUtf8(part))) << part << " in " << text.toStdString();
    EXPECT_EQ(measured.chips(scene::Rgb()).size(), 3U);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/surface_picker.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::scene;
using Eigen::Vector3d;

namespace {

const SurfacePicker& plate() {
    static const SurfacePicker picker(
        std::make_shared<const IndexedMesh>(test::box(Vector3d::Zero(), Vector3d(10, 10, 2))));
    return picker;
}

} // namespace

TEST(SurfacePicker, FindsTheFaceInFront) {
    const auto hit = plate().pick({Vector3d(3, 4, 50), -Vector3d::UnitZ()});
    ASSERT_TRUE(hit);
    EXPECT_NEAR((hit->point - Vector3d(3, 4, 2)).norm(), 0, 1e-6);
    EXPECT_FALSE(plate().pick({Vector3d(20, 2, 5), -Vector3d::UnitZ()}));
}

TEST(SurfacePicker, TellsHowThickTheSolidIsThere) {
    const auto above = plate().pick({Vector3d(3, 4, 50), -Vector3d::UnitZ()});
    ASSERT_TRUE(above);
    EXPECT_NEAR(*plate().thickness(*above), 2, 1e-6);
    const auto beside = plate().pick({Vector3d(50, 4, 1), -Vector3d::UnitX()});
    ASSERT_TRUE(beside);
    EXPECT_NEAR(*plate().thickness(*beside), 10, 1e-6);
}

TEST(SurfacePicker, OfACutSolidItFindsTheSection) {
    const PartingPlane cut{Vector3d::UnitX(), 6};
    const Ray fromTheRight{Vector3d(50, 4, 1), -Vector3d::UnitX()};
    const auto section = plate().pick(fromTheRight, cut);
    ASSERT_TRUE(section);
    EXPECT_EQ(section->face, -1);
    EXPECT_NEAR((section->point - Vector3d(6, 4, 1)).norm(), 0, 1e-9);
    const auto behind = plate().pick({Vector3d(-50, 4, 1), Vector3d::UnitX()}, cut);
    ASSERT_TRUE(behind);
    EXPECT_NEAR(behind->point.x(), 0, 1e-6);
    EXPECT_GE(behind->face, 0);
    EXPECT_FALSE(plate().pick({Vector3d(8, 4, 50), -Vector3d::UnitZ()}, cut)) << "that is cut away";
    EXPECT_TRUE(plate().pick({Vector3d(5, 4, 50), -Vector3d::UnitZ()}, cut));
    EXPECT_FALSE(plate().pick(fromTheRight, PartingPlane{Vector3d::UnitX(), -1})) << "nothing is left";
}

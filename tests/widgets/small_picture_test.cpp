// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/small_picture.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>

using namespace moldwright;
using namespace moldwright::scene;
using Eigen::Vector3d;

namespace {

constexpr int side = 80;

std::array<int, 4> at(const SmallPicture& picture, int x, int y) {
    const std::uint8_t* p = &picture.rgba[4 * (static_cast<std::size_t>(y) * picture.width + x)];
    return {p[0], p[1], p[2], p[3]};
}

/// A cube of side 2 about the origin, seen from the front with 1 mm of air around, cut by a level plane of
/// half size 1.5.
SmallPicture cubeSeenFrom(const Vector3d& direction, std::span<const Rgb> faces) {
    const IndexedMesh cube = test::box(-Vector3d::Ones(), Vector3d::Ones());
    Camera camera = lookingFrom({}, direction);
    camera = fitted(camera, Eigen::AlignedBox3d(Vector3d::Constant(-2), Vector3d::Constant(2)), {side, side});
    PlaneRectangle plane;
    plane.halfU = plane.halfV = 1.5;
    return smallPicture(cube, faces, plane, lightColours(), camera, side, side);
}

} // namespace

TEST(SmallPicture, ShowsTheFacesTowardsTheEyeInTheirColoursOnAClearGround) {
    std::vector<Rgb> faces(12, Rgb::hex(0x0000FF));
    const IndexedMesh cube = test::box(-Vector3d::Ones(), Vector3d::Ones());
    for (int f = 0; f < 12; ++f) // the front is red
        if (cube.corner(f, 0).y() < 0 && cube.corner(f, 1).y() < 0 && cube.corner(f, 2).y() < 0)
            faces[static_cast<std::size_t>(f)] = Rgb::hex(0xFF0000);
    const SmallPicture picture = cubeSeenFrom(-Vector3d::UnitY(), faces);
    ASSERT_EQ(picture.rgba.size(), 4U * side * side);
    const auto front = at(picture, side / 2, side / 2 - 10);
    EXPECT_GT(front[0], 150);
    EXPECT_EQ(front[2], 0);
    EXPECT_EQ(front[3], 255);
    EXPECT_EQ(at(picture, 2, 2)[3], 0);
    const auto behind = at(cubeSeenFrom(Vector3d::UnitY(), faces), side / 2, side / 2 - 10);
    EXPECT_EQ(behind[0], 0);
    EXPECT_GT(behind[2], 150);
}

TEST(SmallPicture, ThePlaneIsGlassBeforeThePartAndHiddenBehindIt) {
    const std::vector<Rgb> faces(12, Rgb::hex(0xFFFFFF));
    const SmallPicture above = cubeSeenFrom(Vector3d(0, -1, 1), faces);
    // Beside the cube, inside the rectangle: clear glass.
    const int opacity = at(above, side / 2 + 17, side / 2)[3];
    EXPECT_GT(opacity, 30);
    EXPECT_LT(opacity, 130);
    // The top lies before the plane.
    const auto top = at(above, side / 2, side / 2 - 12);
    EXPECT_EQ(top[3], 255);
    EXPECT_EQ(top[0], top[2]) << "grey of the lights, not of the glass";
}

TEST(SmallPicture, IsTheSameEachTime) {
    const std::vector<Rgb> faces(12, Rgb::hex(0x808080));
    const Vector3d from(0.75, -1, 0.6);
    EXPECT_EQ(cubeSeenFrom(from, faces).rgba, cubeSeenFrom(from, faces).rgba);
}

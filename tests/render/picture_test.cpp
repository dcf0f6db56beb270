// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/offscreen/picture.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moldwright;
using namespace moldwright::scene;

namespace {

constexpr int size = 200;
const Rgb white = Rgb::hex(0xffffff);

Picture pictureOfBall(const std::vector<Rgb>& colours, Scene& view) {
    const auto context = EglContext::create();
    EXPECT_TRUE(context.has_value()) << context.error().english();
    SceneColours look = lightColours();
    look.viewTop = look.viewBottom = white;
    view.setLook(look, 1);
    view.setSurface(drawnMesh(std::make_shared<const IndexedMesh>(test::sphere({0, 0, 0}, 10, 5))), colours);
    return renderPicture(view, **context, {0, -1, 0}, size, size);
}

/// How many of the picture's pixels are not paper.
double inked(const Picture& picture) {
    int count = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            count += picture.at(x, y) != white ? 1 : 0;
    return count;
}

} // namespace

TEST(Picture, ShowsABallAsADiscOnPaper) {
    Scene view;
    const Picture picture = pictureOfBall({}, view);
    EXPECT_EQ(picture.at(2, 2), white);
    EXPECT_NE(picture.at(size / 2, size / 2), white);
    const Picture part = cropped(picture, white);
    EXPECT_NEAR(part.width, part.height, 3);
    EXPECT_LT(part.width, size);
    // A disc fills π/4 of the square round it.
    const double square = (part.width - 4.0) * (part.height - 4.0);
    EXPECT_NEAR(inked(part) / square, 0.785, 0.02);
}

TEST(Picture, ShowsTheColourOfEachFace) {
    const IndexedMesh ball = test::sphere({0, 0, 0}, 10, 5);
    std::vector<Rgb> colours;
    for (int f = 0; f < ball.faceCount(); ++f)
        colours.push_back(ball.corner(f, 0).x() < 0 ? Rgb::hex(0xd2362b) : Rgb::hex(0x3060d0));
    Scene view;
    const Picture picture = pictureOfBall(colours, view);
    const Rgb left = picture.at(size / 2 - 30, size / 2);
    const Rgb right = picture.at(size / 2 + 30, size / 2);
    EXPECT_GT(left.r, left.b + 40);
    EXPECT_GT(right.b, right.r + 40);
}

TEST(Picture, BecomesAPng) {
    const Picture picture{2, 1, {255, 0, 0, 0, 0, 255}};
    EXPECT_EQ(pngBytes(picture).substr(0, 8), "\x89PNG\r\n\x1a\n");
}

TEST(Picture, OfNothingIsNotCropped) {
    const Picture paper{3, 2, std::vector<std::uint8_t>(18, 255)};
    EXPECT_EQ(cropped(paper, white).width, 3);
    EXPECT_EQ(cropped(paper, white).height, 2);
}

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/contact_paint.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::scene;

namespace {

const Rgb grey = Rgb::hex(0x808080);
const Rgb red = Rgb::hex(0xFF0000);

} // namespace

TEST(ContactPaint, ReddensWhatEitherHalfMeetsWhereItIs) {
    ContactPaint paint;
    paint.setContacts({ContactWays({{{1, 2}}, {}, {{3, 4}}}), ContactWays({{}, {{0, 5}}, {}})});
    EXPECT_TRUE(paint.any());
    EXPECT_EQ(paint.painted({grey, grey, grey}, {1.5, 0.0}, red), (std::vector{red, grey, grey}));
    EXPECT_EQ(paint.facesMet(), 1);
    EXPECT_EQ(paint.painted({grey, grey, grey}, {3.5, 3.5}, red), (std::vector{grey, red, red}));
    EXPECT_EQ(paint.facesMet(), 2);
    EXPECT_EQ(paint.painted({grey, grey, grey}, {9, 9}, red), (std::vector{grey, grey, grey}));
    EXPECT_EQ(paint.facesMet(), 0);
}

TEST(ContactPaint, LeavesColoursAsTheyAreWithoutContact) {
    ContactPaint paint;
    EXPECT_FALSE(paint.any());
    EXPECT_EQ(paint.painted({grey}, {1, 1}, red), std::vector{grey});
}

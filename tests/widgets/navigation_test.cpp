// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/navigation.h"

#include <gtest/gtest.h>

using namespace moldwright::scene;

TEST(Navigation, TheLeftButtonAloneNeverMovesTheCamera) {
    for (const NavigationScheme& scheme : navigationSchemes())
        for (int keys = 0; keys < 8; ++keys)
            EXPECT_EQ(scheme.motionFor({.left = true,
                                        .shift = (keys & 1) != 0,
                                        .ctrl = (keys & 2) != 0,
                                        .alt = (keys & 4) != 0}),
                      Motion::None)
                << scheme.name;
}

TEST(Navigation, EverySchemeCanOrbitPanAndZoom) {
    for (const NavigationScheme& scheme : navigationSchemes()) {
        const auto offers = [&](Motion motion) {
            for (const auto& drag : scheme.drags)
                if (drag.motion == motion)
                    return true;
            return false;
        };
        EXPECT_TRUE(offers(Motion::Orbit)) << scheme.name;
        EXPECT_TRUE(offers(Motion::Pan)) << scheme.name;
        EXPECT_EQ(scheme.wheelFor({.ctrl = true}), Motion::Zoom) << scheme.name;
    }
}

TEST(Navigation, FusionIsTheDefault) {
    EXPECT_EQ(navigationScheme("no such scheme").id, "fusion");
    EXPECT_EQ(navigationScheme("fusion").motionFor({.middle = true}), Motion::Pan);
    EXPECT_EQ(navigationScheme("fusion").motionFor({.middle = true, .shift = true}), Motion::Orbit);
}

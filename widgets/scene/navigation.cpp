// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/navigation.h"

#include <algorithm>

namespace moldwright::scene {

namespace {

constexpr Held middle{.middle = true};
constexpr Held shiftMiddle{.middle = true, .shift = true};
constexpr Held ctrlMiddle{.middle = true, .ctrl = true};
constexpr Held right{.right = true};
constexpr Held shiftRight{.right = true, .shift = true};
constexpr Held ctrlRight{.right = true, .ctrl = true};
constexpr Held middleAndLeft{.left = true, .middle = true};
constexpr Held middleAndRight{.middle = true, .right = true};

} // namespace

std::span<const NavigationScheme> navigationSchemes() {
    static const std::vector<NavigationScheme> schemes = {
        {"fusion",
         "Fusion",
         {{middle, Motion::Pan}, {shiftMiddle, Motion::Orbit}, {ctrlMiddle, Motion::Zoom}}},
        {"solidworks",
         "SolidWorks",
         {{middle, Motion::Orbit}, {ctrlMiddle, Motion::Pan}, {shiftMiddle, Motion::Zoom}}},
        {"freecad",
         "FreeCAD",
         {{middle, Motion::Pan},
          {middleAndLeft, Motion::Orbit},
          {middleAndRight, Motion::Orbit},
          {shiftRight, Motion::Orbit},
          {ctrlRight, Motion::Pan}}},
        {"blender",
         "Blender",
         {{middle, Motion::Orbit}, {shiftMiddle, Motion::Pan}, {ctrlMiddle, Motion::Zoom}}},
        {"prusaslicer",
         "PrusaSlicer",
         {{right, Motion::Orbit}, {middle, Motion::Pan}, {shiftRight, Motion::Pan}}},
        {"touchpad",
         "Touchpad",
         {{right, Motion::Orbit},
          {shiftRight, Motion::Pan},
          {middle, Motion::Pan},
          {shiftMiddle, Motion::Orbit}},
         Motion::Orbit},
    };
    return schemes;
}

const NavigationScheme& navigationScheme(const std::string& id) {
    const auto schemes = navigationSchemes();
    const auto found = std::ranges::find(schemes, id, &NavigationScheme::id);
    return found == schemes.end() ? schemes.front() : *found;
}

Motion NavigationScheme::motionFor(const Held& held) const {
    const auto found = std::ranges::find(drags, held, &Drag::held);
    return found == drags.end() ? Motion::None : found->motion;
}

Motion NavigationScheme::wheelFor(const Held& held) const {
    if (held.ctrl || wheel == Motion::Zoom)
        return Motion::Zoom;
    return held.shift ? Motion::Pan : wheel;
}

} // namespace moldwright::scene

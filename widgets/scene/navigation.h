// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

namespace moldwright::scene {

enum class Motion { None, Orbit, Pan, Zoom };

/// Mouse buttons and modifier keys that are held. The keyboard alone never moves the camera.
struct Held {
    bool left = false;
    bool middle = false;
    bool right = false;
    bool shift = false;
    bool ctrl = false;
    bool alt = false;

    bool operator==(const Held&) const = default;
};

/// How mouse and wheel move the camera, in the habit of one program. The left button alone never does: it
/// selects and uses the tool.
struct NavigationScheme {
    struct Drag {
        Held held;
        Motion motion;
    };
    std::string id;   ///< as stored in the settings
    std::string name; ///< as shown; a program's name, not translated
    std::vector<Drag> drags;
    Motion wheel = Motion::Zoom; ///< Touchpad: two fingers orbit

    [[nodiscard]] Motion motionFor(const Held& held) const;

    /// What the wheel or two fingers do with these keys held.
    [[nodiscard]] Motion wheelFor(const Held& held) const;
};

/// All schemes; the first is the default.
[[nodiscard]] std::span<const NavigationScheme> navigationSchemes();

/// The scheme with this id, else the default.
[[nodiscard]] const NavigationScheme& navigationScheme(const std::string& id);

} // namespace moldwright::scene

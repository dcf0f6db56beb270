// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace moldwright::scene {

struct Rgb {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;

    /// From 0xRRGGBB.
    [[nodiscard]] static constexpr Rgb hex(unsigned value) {
        return {static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8 & 0xff),
                static_cast<std::uint8_t>(value & 0xff)};
    }
    /// Channels in [0, 1], as VTK wants them.
    [[nodiscard]] std::array<double, 3> unit() const { return {r / 255., g / 255., b / 255.}; }

    bool operator==(const Rgb&) const = default;
};

/// What each colour in a view means. One set per theme; a meaning never changes its hue.
struct SceneColours {
    Rgb viewTop;
    Rgb viewBottom;
    Rgb part;
    Rgb undercut;
    Rgb plane;
    double planeOpacity = 0.24;
    Rgb partingLine;
    Rgb side1;
    Rgb side2;
    Rgb side1Ink;
    Rgb side2Ink;
    Rgb half1;
    Rgb half2;
    Rgb accent;
    Rgb pin;
    Rgb pinLine;
    Rgb crease;
    Rgb errorInk;
    Rgb chip;
    Rgb chipEdge;
    Rgb text;
    Rgb secondaryText;
    Rgb cube;
    Rgb cubeEdge;
};

[[nodiscard]] SceneColours lightColours();
[[nodiscard]] SceneColours darkColours();

/// Draft classes about the required draft, worst first: below −15°, −15 to −5, −5 to 0, 0 to required,
/// required to 3, 3 to 10, above. Lightness rises all the way, so that a grey print reads.
[[nodiscard]] const std::array<Rgb, 7>& draftClassColours();

/// Importance of 2, 4, 8, 16 and 32 or more: darker is heavier.
[[nodiscard]] const std::array<Rgb, 5>& importanceColours();

/// Class of a weight: 0 for plain, else 1 … 5 by how often it was doubled.
[[nodiscard]] int importanceClass(double weight);

/// A colour per face: that of undercuts where `violating` is 1, else the part's.
[[nodiscard]] std::vector<Rgb> undercutColours(const std::vector<std::uint8_t>& violating,
                                               const SceneColours& colours);

/// Class of a draft angle, 0 … 6, when `required` degrees are asked for.
[[nodiscard]] int draftClass(double degrees, double required);

} // namespace moldwright::scene

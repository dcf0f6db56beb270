// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/colours.h"

#include <algorithm>
#include <cmath>

namespace moldwright::scene {

SceneColours lightColours() {
    return {.viewTop = Rgb::hex(0xF7F8FA),
            .viewBottom = Rgb::hex(0xE2E6EB),
            .part = Rgb::hex(0xC6CBD1),
            .undercut = Rgb::hex(0xD2362B),
            .plane = Rgb::hex(0x64748A),
            .planeOpacity = 0.24,
            .partingLine = Rgb::hex(0x14181D),
            .side1 = Rgb::hex(0x0A5F78),
            .side2 = Rgb::hex(0xB97A0C),
            .side1Ink = Rgb::hex(0x0A5F78),
            .side2Ink = Rgb::hex(0x8A5300),
            .half1 = Rgb::hex(0x93AAB6),
            .half2 = Rgb::hex(0xB9AC8E),
            .accent = Rgb::hex(0x1A63B5),
            .pin = Rgb::hex(0xD12E88),
            .pinLine = Rgb::hex(0xD12E88),
            .crease = Rgb::hex(0xE08A00),
            .errorInk = Rgb::hex(0xC2231A),
            .chip = Rgb::hex(0xF5F6F8),
            .chipEdge = Rgb::hex(0xCDD3DA),
            .text = Rgb::hex(0x1A1F26),
            .secondaryText = Rgb::hex(0x545E6B),
            .cube = Rgb::hex(0xFFFFFF),
            .cubeEdge = Rgb::hex(0x64748A)};
}

SceneColours darkColours() {
    return {.viewTop = Rgb::hex(0x343A42),
            .viewBottom = Rgb::hex(0x1A1D21),
            .part = Rgb::hex(0xB9BFC6),
            .undercut = Rgb::hex(0xE5483C),
            .plane = Rgb::hex(0x9DB0C6),
            .planeOpacity = 0.30,
            .partingLine = Rgb::hex(0x0C0E11),
            .side1 = Rgb::hex(0x4FB9D6),
            .side2 = Rgb::hex(0xE3A54A),
            .side1Ink = Rgb::hex(0x4FB9D6),
            .side2Ink = Rgb::hex(0xE3A54A),
            .half1 = Rgb::hex(0x7B95A1),
            .half2 = Rgb::hex(0xA4977A),
            .accent = Rgb::hex(0x3273C6),
            .pin = Rgb::hex(0xD12E88),
            .pinLine = Rgb::hex(0xFF7CC3),
            .crease = Rgb::hex(0xF0B453),
            .errorInk = Rgb::hex(0xFF857B),
            .chip = Rgb::hex(0x2B3036),
            .chipEdge = Rgb::hex(0x3C434B),
            .text = Rgb::hex(0xE8EBEF),
            .secondaryText = Rgb::hex(0xA9B2BD),
            .cube = Rgb::hex(0x2B3036),
            .cubeEdge = Rgb::hex(0x8A96A3)};
}

const std::array<Rgb, 7>& draftClassColours() {
    static constexpr std::array<Rgb, 7> colours = {Rgb::hex(0x5E0E18), Rgb::hex(0x9E1E1F), Rgb::hex(0xD2452F),
                                                   Rgb::hex(0xDE8B34), Rgb::hex(0x93C0E0), Rgb::hex(0xBDDCF0),
                                                   Rgb::hex(0xE9F4FB)};
    return colours;
}

const std::array<Rgb, 5>& importanceColours() {
    static constexpr std::array<Rgb, 5> colours = {Rgb::hex(0xD8CBF0), Rgb::hex(0xB59BE2), Rgb::hex(0x8F6CCB),
                                                   Rgb::hex(0x6A43AB), Rgb::hex(0x452480)};
    return colours;
}

int importanceClass(double weight) {
    return weight > 1 ? std::clamp(static_cast<int>(std::lround(std::log2(weight))), 1, 5) : 0;
}

std::vector<Rgb> undercutColours(const std::vector<std::uint8_t>& violating, const SceneColours& colours) {
    std::vector<Rgb> result;
    result.reserve(violating.size());
    for (const std::uint8_t bad : violating)
        result.push_back(bad ? colours.undercut : colours.part);
    return result;
}

int draftClass(double degrees, double required) {
    // A required draft above 3° or 10° leaves its upper classes empty instead of reversing them.
    const std::array<double, 6> edges = {
        -15, -5, 0, required, std::max(3.0, required), std::max(10.0, required)};
    return static_cast<int>(std::ranges::upper_bound(edges, degrees) - edges.begin());
}

} // namespace moldwright::scene

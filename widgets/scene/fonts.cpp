// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/fonts.h"

#include <array>
#include <filesystem>

namespace moldwright::scene {

const ViewFonts& viewFonts() {
    static const ViewFonts fonts = [] {
        const std::array<ViewFonts, 2> known = {{{"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                                                  "/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf"},
                                                 {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                                  "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"}}};
        for (const ViewFonts& candidate : known)
            if (std::filesystem::exists(candidate.regular) && std::filesystem::exists(candidate.bold))
                return candidate;
        return ViewFonts{};
    }();
    return fonts;
}

} // namespace moldwright::scene

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/fonts.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>

namespace moldwright::scene {

namespace {

struct FontFiles {
    std::string regular;
    std::string bold;
};

FontFiles firstInstalled(std::initializer_list<FontFiles> known) {
    const auto there = [](const FontFiles& files) {
        return std::filesystem::exists(files.regular) && std::filesystem::exists(files.bold);
    };
    const auto* found = std::find_if(known.begin(), known.end(), there);
    return found == known.end() ? FontFiles{} : *found;
}

const FontFiles& westernFonts() {
    static const FontFiles fonts = firstInstalled({{"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                                                    "/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf"},
                                                   {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                                    "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"}});
    return fonts;
}

const FontFiles& chineseFonts() {
    static const std::string microHei = "/usr/share/fonts/truetype/wqy/wqy-microhei.ttc"; // has no bold
    static const FontFiles fonts = firstInstalled({{microHei, microHei},
                                                   {"/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc",
                                                    "/usr/share/fonts/opentype/noto/NotoSansCJK-Bold.ttc"}});
    return fonts;
}

/// Whether a text holds a sign from U+3000 on, by the first bytes of its UTF-8.
bool isChinese(const std::string& text) {
    return std::any_of(text.begin(), text.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte >= 0xE3 && byte <= 0xEF;
    });
}

} // namespace

const std::string& viewFontFor(const std::string& text, bool bold) {
    const FontFiles& fonts = isChinese(text) ? chineseFonts() : westernFonts();
    return bold ? fonts.bold : fonts.regular;
}

} // namespace moldwright::scene

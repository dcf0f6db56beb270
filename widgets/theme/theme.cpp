// SPDX-License-Identifier: AGPL-3.0-or-later
#include "theme/theme.h"

#include <QApplication>
#include <QGuiApplication>

namespace moldwright {

namespace {

struct Grounds {
    QColor window, panel, base, alternate, button, text, secondary, disabled, hairline, outline, accent, link,
        toolTip;
};

QPalette paletteFrom(const Grounds& g) {
    QPalette p;
    p.setColor(QPalette::Window, g.window);
    p.setColor(QPalette::Base, g.base);
    p.setColor(QPalette::AlternateBase, g.alternate);
    p.setColor(QPalette::Button, g.button);
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        p.setColor(role, g.text);
        p.setColor(QPalette::Disabled, role, g.disabled);
    }
    p.setColor(QPalette::PlaceholderText, g.secondary);
    p.setColor(QPalette::BrightText, QColor(Qt::white));
    p.setColor(QPalette::Midlight, g.hairline);
    p.setColor(QPalette::Mid, g.outline);
    p.setColor(QPalette::Light, g.button.lighter(110));
    p.setColor(QPalette::Dark, g.outline.darker(120));
    p.setColor(QPalette::Shadow, g.outline.darker(160));
    p.setColor(QPalette::Highlight, g.accent);
    p.setColor(QPalette::Disabled, QPalette::Highlight, g.outline);
    p.setColor(QPalette::HighlightedText, QColor(Qt::white));
    p.setColor(QPalette::Link, g.link);
    p.setColor(QPalette::LinkVisited, g.link);
    p.setColor(QPalette::ToolTipBase, g.toolTip);
    return p;
}

Theme lightTheme() {
    Theme t;
    t.palette =
        paletteFrom({QColor(0xECEEF1), QColor(0xF5F6F8), QColor(0xFFFFFF), QColor(0xF6F7F9), QColor(0xFBFCFD),
                     QColor(0x1A1F26), QColor(0x545E6B), QColor(0x8B949F), QColor(0xCDD3DA), QColor(0x7A8490),
                     QColor(0x1A63B5), QColor(0x1A5FAE), QColor(0xFFFFFF)});
    t.panel = QColor(0xF5F6F8);
    t.accentSoft = QColor(0xDCE9F8);
    t.outline = QColor(0x7A8490);
    t.outlineSeed = QColor(0xABB9CA);
    t.error = QColor(0xC2231A);
    t.warning = QColor(0x8A5300);
    t.done = QColor(0x1B7340);
    t.bannerRed = QColor(0xFBE4E1);
    t.bannerAmber = QColor(0xFBEFD5);
    t.bannerGreen = QColor(0xDDF1E4);
    t.scene = scene::lightColours();
    return t;
}

Theme darkTheme() {
    Theme t;
    t.dark = true;
    t.palette =
        paletteFrom({QColor(0x25292E), QColor(0x2B3036), QColor(0x1B1E22), QColor(0x20242A), QColor(0x353B43),
                     QColor(0xE8EBEF), QColor(0xA9B2BD), QColor(0x6F7883), QColor(0x3C434B), QColor(0x707B87),
                     QColor(0x3273C6), QColor(0x7FB6F5), QColor(0x2B3036)});
    t.panel = QColor(0x2B3036);
    t.accentSoft = QColor(0x263C57);
    t.outline = QColor(0x707B87);
    t.outlineSeed = QColor(0x9DACBD);
    t.error = QColor(0xFF857B);
    t.warning = QColor(0xF0B453);
    t.done = QColor(0x63CC8E);
    t.bannerRed = QColor(0x45221F);
    t.bannerAmber = QColor(0x40331C);
    t.bannerGreen = QColor(0x1E3A2A);
    t.scene = scene::darkColours();
    return t;
}

Theme& current() {
    static Theme theme = lightTheme();
    return theme;
}

bool desktopIsDark() {
    static const bool dark = QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
    return dark;
}

} // namespace

const Theme& theme() {
    return current();
}

void useTheme(ThemeChoice choice) {
    const bool systemDark = desktopIsDark(); // asked before the palette is ours
    const bool dark = choice == ThemeChoice::Dark || (choice == ThemeChoice::System && systemDark);
    current() = dark ? darkTheme() : lightTheme();
    QApplication::setPalette(theme().palette);
}

QColor toColor(scene::Rgb rgb) {
    return {rgb.r, rgb.g, rgb.b};
}

} // namespace moldwright

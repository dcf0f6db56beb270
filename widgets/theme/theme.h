// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/colours.h"

#include <QColor>
#include <QPalette>

namespace moldwright {

enum class ThemeChoice { System, Light, Dark };

/// The colours of the window. QPalette holds what it has roles for; the rest is here.
struct Theme {
    bool dark = false;
    QPalette palette;
    QColor panel;       ///< ground of docks
    QColor accentSoft;  ///< ground of the active step and tool
    QColor outline;     ///< outline of fields, at least 3:1 on the panel
    QColor outlineSeed; ///< Fusion darkens it by 140 % to `outline`
    QColor error;
    QColor warning;
    QColor done;
    QColor bannerRed;
    QColor bannerAmber;
    QColor bannerGreen;
    scene::SceneColours scene;
};

/// The theme in use.
[[nodiscard]] const Theme& theme();

/// Takes a theme into use: palette, style sheet and icons follow at once. System follows the desktop's
/// colours as they were when the program started.
void useTheme(ThemeChoice choice);

[[nodiscard]] QColor toColor(scene::Rgb rgb);

} // namespace moldwright

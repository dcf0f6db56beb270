// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace moldwright::scene {

/// Font files for text in views: VTK's own fonts lack signs such as ✓, − and the letters of many languages.
struct ViewFonts {
    std::string regular; ///< empty when no font file was found; VTK's own is used then
    std::string bold;
};

/// Noto Sans where it is installed, else DejaVu Sans.
[[nodiscard]] const ViewFonts& viewFonts();

} // namespace moldwright::scene

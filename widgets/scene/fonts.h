// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace moldwright::scene {

/// The font file for a text (UTF-8) in a view: VTK's own fonts lack signs such as ✓, − and the letters of
/// many languages, and it falls back to no other. Noto Sans where it is installed, else DejaVu Sans; for
/// Chinese WenQuanYi Micro Hei or Noto Sans CJK. Empty where none is found; VTK's own is used then.
[[nodiscard]] const std::string& viewFontFor(const std::string& text, bool bold);

} // namespace moldwright::scene

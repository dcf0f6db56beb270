// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

#include <optional>

namespace moldwright {

/// An icon of our family by its file name in resources/icons. Drawn for the exact size and ratio, in the
/// colours of the theme in use when it is painted: line in text colour, one shape in accent; line only at 16
/// px and when disabled; white when selected.
[[nodiscard]] QIcon themeIcon(const QString& name);

/// The same in one colour, for a state or a side.
[[nodiscard]] QIcon tintedIcon(const QString& name, const QColor& colour);

/// How a step, message or check stands; each has an icon of its own shape and colour.
enum class Standing { Todo, Info, Done, Stale, Warning, Failing, Running };
[[nodiscard]] QIcon standingIcon(Standing standing);
[[nodiscard]] QColor standingColour(Standing standing);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/design.h"
#include "scene/overlay.h"

#include <QString>

#include <vector>

namespace moldwright {

/// What an obstruction is called: "Handle".
[[nodiscard]] QString kindName(Obstruction::Kind kind);

/// Its size: "34.2 mm".
[[nodiscard]] QString sizeText(const Obstruction& obstruction);

/// The command that would remove most of its kind, by its id.
[[nodiscard]] QString remedyFor(const Obstruction& obstruction);

/// A mark in the view at the place of each, with kind and size; the chosen one in bold.
[[nodiscard]] std::vector<scene::Chip> marksOf(const std::vector<Obstruction>& obstructions, int chosen);

/// The id of an obstruction in tree and panel, and its number; −1 for the id of anything else.
[[nodiscard]] QString obstructionId(int number);
[[nodiscard]] int obstructionNumber(const QString& id);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/mold_settings.h"
#include "panels/property_panel.h"

class QWidget;

namespace moldwright {

class Actions;
class Workbench;

/// The row by which a preset is taken, and the buttons that save and remove one; presets are files of the
/// user's own.
[[nodiscard]] PropertySection presetSection(const Actions& actions);
[[nodiscard]] QString presetRow();

/// What the row offers after its first choice, "as set here".
[[nodiscard]] QStringList presetNamesShown();

/// Which choice the row shows: the preset that the settings are, else 0.
[[nodiscard]] int presetShown(const MoldSettings& settings);

/// The settings with the preset of that choice; as they are where it cannot be read.
[[nodiscard]] MoldSettings withPresetShown(const MoldSettings& settings, int choice);

/// What the commands save-preset and remove-preset do: the first asks for a name in a dialog over `window`,
/// the second forgets the preset that the settings are, so nothing is lost.
void connectPresets(Actions& actions, Workbench& bench, QWidget* window);

} // namespace moldwright

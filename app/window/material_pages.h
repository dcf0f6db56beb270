// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "panels/property_panel.h"
#include "project/project.h"

class QWidget;

namespace moldwright {

class Actions;
class Workbench;

/// The row by which a material is taken from the table of materials, what it says, and the buttons that go
/// with it.
[[nodiscard]] PropertySection materialSection(const Project& project, const Actions& actions);
[[nodiscard]] QString materialRow();

/// Another word for another section: it is to be laid out anew.
[[nodiscard]] QString materialLayout(const Project& project);
void fillMaterialSection(PropertyPanel& panel, const Project& project);

/// The settings with the material of that choice: 0 none, then the table's, then the settings' own where the
/// table has another of that name, or none.
[[nodiscard]] MoldSettings withMaterialShown(const MoldSettings& settings, int choice);

/// What the commands edit-materials and take-material-draft do; `window`: over which the dialog stands.
void connectMaterials(Actions& actions, Workbench& bench, QWidget* window);

} // namespace moldwright

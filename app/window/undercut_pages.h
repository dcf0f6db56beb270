// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "panels/project_tree.h"
#include "panels/property_panel.h"
#include "scene/overlay.h"

#include <QString>

#include <vector>

namespace moldwright {

class Actions;
class Workbench;

/// The id of an undercut in tree and panel, and its number; −1 for the id of anything else.
[[nodiscard]] QString undercutId(int number);
[[nodiscard]] int undercutNumber(const QString& id);

/// Adds the undercuts that are known to the tree's rows, under the row `parent`.
void addUndercutRows(std::vector<ProjectRow>& rows, int parent, const Workbench& bench);

/// The page of one undercut, or of all of them for any other number.
[[nodiscard]] PropertyPage undercutPage(int number, const Workbench& bench, const Actions& actions);
void fillUndercutPage(PropertyPanel& panel, const Workbench& bench);
/// Takes a treatment chosen in the panel; false for the id of anything else.
bool applyTreatment(Workbench& bench, const QString& id, int choice);

/// The undercuts that are marked in the view: when one of them, or all, are selected.
[[nodiscard]] std::vector<int> markedUndercuts(const Workbench& bench, const QString& selected);
/// Their marks, with volume and treatment; the chosen one in bold.
[[nodiscard]] std::vector<scene::Chip> undercutMarks(const Workbench& bench, const QString& selected);

/// The walls that filling the chosen undercut would make; null for none.
[[nodiscard]] SharedMesh shownFilling(const Workbench& bench, const QString& selected);

} // namespace moldwright

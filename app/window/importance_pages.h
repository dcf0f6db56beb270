// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "panels/project_tree.h"
#include "panels/property_panel.h"

#include <QString>

#include <vector>

namespace moldwright {

class Actions;
class Workbench;
struct Visibility;

/// The id of a region in tree and panel, and its number; −1 for the id of anything else.
[[nodiscard]] QString regionId(int number);
[[nodiscard]] int regionNumber(const QString& id);
/// Those of the regions among what is chosen, ascending.
[[nodiscard]] std::vector<int> regionNumbers(const QString& selected);
/// The id of all regions together.
[[nodiscard]] QString allRegionsId();
/// Whether all regions or one of them is selected.
[[nodiscard]] bool regionsChosen(const QString& selected);

/// Adds the regions to the tree's rows; one that missed its limit is told in red.
void addRegionRows(std::vector<ProjectRow>& rows, const Workbench& bench, const Visibility& visible);

/// The page of the regions chosen, or of importance as a whole where none is.
[[nodiscard]] PropertyPage regionPage(const QString& selected, const Workbench& bench,
                                      const Actions& actions);
void fillRegionPage(PropertyPanel& panel, const Workbench& bench);
/// Takes a value of the page shown (pageId); false for the id of anything else.
bool applyRegionValue(Workbench& bench, const QString& id, const QString& page, double value, bool preview);

} // namespace moldwright

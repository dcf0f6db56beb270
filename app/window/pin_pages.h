// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "panels/project_tree.h"
#include "panels/property_panel.h"
#include "scene/overlay.h"
#include "scene/pin_layer.h"

#include <QString>

#include <vector>

namespace moldwright {

class Actions;
class Workbench;
struct Visibility;

/// The id of a pin in tree and panel, and its number; −1 for the id of anything else.
[[nodiscard]] QString pinId(int number);
[[nodiscard]] int pinNumber(const QString& id);
/// Those of the pins among what is chosen, ascending.
[[nodiscard]] std::vector<int> pinNumbers(const QString& selected);
/// Whether all pins, the suggested ones, or one of them is selected.
[[nodiscard]] bool pinsChosen(const QString& selected);

/// Adds the pins to the tree's rows.
void addPinRows(std::vector<ProjectRow>& rows, const Workbench& bench, const Visibility& visible);

/// The page of the pins chosen, or of all of them where none is.
[[nodiscard]] PropertyPage pinPage(const QString& selected, const Workbench& bench, const Actions& actions);
void fillPinPage(PropertyPanel& panel, const Workbench& bench);
/// Takes a value of the page shown (pageId); false for the id of anything else.
bool applyPinValue(Workbench& bench, const QString& id, const QString& page, double value, bool preview);

/// What the views show of them; `suggested`: the suggested ones too.
[[nodiscard]] scene::ShownPins shownPins(const Workbench& bench, const QString& selected, bool suggested,
                                         const Visibility& visible);
/// A chip at the chosen pin with its way to the plane.
[[nodiscard]] std::vector<scene::Chip> pinChips(const Workbench& bench, const QString& selected);

} // namespace moldwright

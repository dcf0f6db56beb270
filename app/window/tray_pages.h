// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "panels/project_tree.h"
#include "panels/property_panel.h"
#include "scene/overlay.h"

#include <QString>

#include <Eigen/Geometry>

#include <vector>

namespace moldwright {

class Actions;
class Workbench;

/// Different parts in one mold: 0 is the cast of the project itself, 1 and up are its further parts.

/// The id of a part of the mold in tree and panel, and its number; −1 for the id of anything else.
[[nodiscard]] QString trayId(int number);
[[nodiscard]] int trayNumber(const QString& id);

/// How many rows the parts have: none where there is one part only.
[[nodiscard]] std::size_t trayRowCount(const Workbench& bench);
/// Adds them to the tree's rows, under the row `parent`.
void addTrayRows(std::vector<ProjectRow>& rows, int parent, const Workbench& bench);

/// What the mold is of, in a line: how many cavities each part has, or why it cannot be built so.
[[nodiscard]] QString trayWords(const Workbench& bench);
/// Adds a section to the page of the mold, after the layout's: its parts and how many cavities each has.
void addTraySection(PropertyPage& page, const Workbench& bench, const Actions& actions);

/// A box about the cavities of one part in the plan, in the part's frame, mm; empty while there is none.
[[nodiscard]] Eigen::AlignedBox3d trayPlace(int number, const Workbench& bench);

/// Whose each cavity of the plan is, where the mold has several parts; those of the chosen one in bold.
[[nodiscard]] std::vector<scene::Chip> trayChips(const Workbench& bench, const QString& selected);

/// The page of one part.
[[nodiscard]] PropertyPage trayPage(int number, const Workbench& bench, const Actions& actions);
/// Writes the values of that page and of the section.
void fillTrayPage(PropertyPanel& panel, const Workbench& bench);
/// Takes a value typed there; false for the id of anything else.
bool applyTrayValue(Workbench& bench, const QString& id, int value, bool preview);

} // namespace moldwright

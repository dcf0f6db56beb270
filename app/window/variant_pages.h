// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "panels/project_tree.h"
#include "panels/property_panel.h"

#include <QString>

#include <vector>

namespace moldwright {

class Actions;
class Workbench;

/// The id of a variant in tree and panel, and its number; −1 for the id of anything else.
[[nodiscard]] QString variantId(int number);
[[nodiscard]] int variantNumber(const QString& id);
/// The id of all variants together.
[[nodiscard]] QString allVariantsId();
/// Whether all variants or one of them is selected.
[[nodiscard]] bool variantsChosen(const QString& selected);
/// The variant that a command is for while this is selected: the one that is, else the current one.
[[nodiscard]] int variantMeant(const QString& selected, const Workbench& bench);

/// Adds the variants to the tree's rows.
void addVariantRows(std::vector<ProjectRow>& rows, const Workbench& bench);

/// The page of all variants: one table, in which one of them is chosen.
[[nodiscard]] PropertyPage variantPage(const Workbench& bench, const Actions& actions);
void fillVariantPage(PropertyPanel& panel, const QString& selected, const Workbench& bench);

} // namespace moldwright

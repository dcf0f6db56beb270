// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "panels/property_panel.h"

#include <QString>

namespace moldwright {

class Actions;
class Workbench;

/// The property page for what is selected in the project's tree, as a table.
[[nodiscard]] PropertyPage propertyPage(const QString& selected, const Workbench& bench,
                                        const Actions& actions);

/// Writes the workbench's values into the page that the panel shows.
void fillPage(PropertyPanel& panel, const Workbench& bench);

/// Takes a value typed or dragged on a page of the panel into the document: a preview while dragged, else one
/// undo step.
void applyProperty(Workbench& bench, const QString& page, const QString& id, const QVariant& value,
                   bool preview);

} // namespace moldwright

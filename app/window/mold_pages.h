// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "panels/property_panel.h"
#include "project/project.h"

#include <optional>

namespace moldwright {

class Actions;
class Workbench;

/// The page of the mold: block, cavities, shrink, features, and what was measured of it once it is built.
[[nodiscard]] PropertyPage moldPage(const Workbench& bench, const Actions& actions);
void fillMoldPage(PropertyPanel& panel, const Workbench& bench);

/// The project with a value of that page taken; none for the id of anything else, or where nothing changes.
[[nodiscard]] std::optional<Project> withMoldValue(const Project& project, const QString& id,
                                                   const QVariant& value);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/plaque.h"
#include "project/project.h"

namespace moldwright {

/// What the title block of a drawing says of the project's part.
[[nodiscard]] PartTitle titleOf(const Project& project);

/// The project with another title; blanks at both ends are dropped, and an empty name leaves the name.
[[nodiscard]] Project withTitle(Project project, const PartTitle& title);

/// The mold's settings as a mold is built with them: plaque with the words that its text stands for.
[[nodiscard]] MoldSettings moldAsBuilt(const Project& project);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/presentation.h"

#include <QString>

namespace moldwright {

class Workbench;

/// The step of the job that a row of the project tree belongs to.
[[nodiscard]] Step stepOf(const QString& id);

/// What is selected, or where it was in the tree when it is gone.
[[nodiscard]] QString stillThere(const QString& selected, const Workbench& bench);

} // namespace moldwright

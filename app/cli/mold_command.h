// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace moldwright::cli {

/// The command `mold`: builds, proves and writes the mold of a project that holds a cast.
[[nodiscard]] Command moldCommand();

} // namespace moldwright::cli

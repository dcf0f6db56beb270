// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace moldwright::cli {

/// The command `info`: what a project file holds.
[[nodiscard]] Command infoCommand();

} // namespace moldwright::cli

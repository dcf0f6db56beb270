// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace moldwright::cli {

/// The command `report`: the printable report of a project.
[[nodiscard]] Command reportCommand();

} // namespace moldwright::cli

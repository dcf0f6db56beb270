// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace moldwright::cli {

/// `pins IN`: points of a mesh that may be worth pinning to the parting plane.
[[nodiscard]] Command pinsCommand();

} // namespace moldwright::cli

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace moldwright::cli {

/// `plane IN`: the best parting planes of a mesh with their directions.
[[nodiscard]] Command planeCommand();

} // namespace moldwright::cli

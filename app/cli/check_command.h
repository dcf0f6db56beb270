// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace moldwright::cli {

/// `check IN`: reads a mesh, mends what needs no choice, and says whether it can be designed with, or why
/// not.
[[nodiscard]] Command checkCommand();

} // namespace moldwright::cli

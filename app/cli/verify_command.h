// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace moldwright::cli {

/// The command `verify`: the certificate of castability on files as they were written.
[[nodiscard]] Command verifyCommand();

} // namespace moldwright::cli

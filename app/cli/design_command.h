// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace moldwright::cli {

/// `design IN --out DIR`: the whole of Algorithm 1 unattended, from a mesh to a proved cast and, on request,
/// its mold.
[[nodiscard]] Command designCommand();

} // namespace moldwright::cli

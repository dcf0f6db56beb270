// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace moldwright::cli {

/// `analyze IN --plane …`: draft and undercuts of a mesh at a plane.
[[nodiscard]] Command analyzeCommand();

} // namespace moldwright::cli

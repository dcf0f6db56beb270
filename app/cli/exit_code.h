// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"

namespace moldwright::cli {

/// What the program's exit code says. A contract: values do not change.
enum class ExitCode {
    Yes = 0,        ///< done, and the answer is yes
    No = 1,         ///< done, and the answer is no
    Usage = 2,      ///< wrong usage
    BadInput = 3,   ///< an input cannot be used, or an output cannot be written
    Impossible = 4, ///< a named obstruction stands in the way of these choices
    Stopped = 5,    ///< cancelled or out of time
    Internal = 70   ///< an error inside the program
};

[[nodiscard]] ExitCode exitCodeOf(ErrorCode code);

} // namespace moldwright::cli

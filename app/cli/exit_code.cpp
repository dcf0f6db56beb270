// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/exit_code.h"

namespace moldwright::cli {

ExitCode exitCodeOf(ErrorCode code) {
    switch (code) {
    case ErrorCode::Usage:
        return ExitCode::Usage;
    case ErrorCode::BadInput:
    case ErrorCode::WriteFailed:
        return ExitCode::BadInput;
    case ErrorCode::Impossible:
        return ExitCode::Impossible;
    case ErrorCode::Cancelled:
        return ExitCode::Stopped;
    case ErrorCode::Worker:
    case ErrorCode::Internal:
        break;
    }
    return ExitCode::Internal;
}

} // namespace moldwright::cli

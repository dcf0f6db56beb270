// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace moldwright::cli {

/// The whole of moldwright-cli: parses, runs the command, tells what went wrong, and returns the exit code.
[[nodiscard]] int runProgram(int argc, const char* const* argv);

} // namespace moldwright::cli

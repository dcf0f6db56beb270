// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace moldwright::render {

/// Runs the picture program: one job from the file named on the command line, or from standard input. Answers
/// on standard output as JSON ("pages", "missing"), failures as a sentence on standard error. Exit codes as
/// the command line's.
[[nodiscard]] int runProgram(int argc, char** argv);

} // namespace moldwright::render

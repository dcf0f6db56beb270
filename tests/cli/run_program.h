// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace moldwright::test {

/// How a run of moldwright-cli ended and what it said.
struct Run {
    int exitCode = -1;
    std::string out;
    std::string err;
};

/// Runs the real moldwright-cli with these arguments; `interruptAfter`, if not zero, sends it SIGINT then.
Run runProgram(const std::vector<std::string>& arguments, std::chrono::milliseconds interruptAfter = {});

} // namespace moldwright::test

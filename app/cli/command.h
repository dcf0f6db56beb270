// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "cli/exit_code.h"
#include "cli/session.h"

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace moldwright::cli {

/// Runs a command whose options were parsed. A failure is told by the program, which also chooses its exit
/// code.
using Action = std::function<Result<ExitCode>(const Session&)>;

/// One command of the program. Each lives in a file of its own and has a line in the table of commands.cpp.
struct Command {
    std::string name;
    std::string summary; ///< one line, for the list of commands
    std::string manual;  ///< paragraphs below the options: what it does, what the JSON holds, examples

    /// Declares the command's own options on `app` and returns what runs it. The options must live as long as
    /// the action: keep them in a shared_ptr that the action holds.
    std::function<Action(CLI::App& app)> declare;
};

/// All commands, in the order in which the help lists them.
[[nodiscard]] const std::vector<Command>& commands();

} // namespace moldwright::cli

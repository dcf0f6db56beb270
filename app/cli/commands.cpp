// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/check_command.h"
#include "cli/command.h"

namespace moldwright::cli {

const std::vector<Command>& commands() {
    static const std::vector<Command> all = {
        checkCommand(),
    };
    return all;
}

} // namespace moldwright::cli

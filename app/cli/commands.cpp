// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/analyze_command.h"
#include "cli/check_command.h"
#include "cli/command.h"
#include "cli/design_command.h"
#include "cli/info_command.h"
#include "cli/mold_command.h"
#include "cli/pins_command.h"
#include "cli/plane_command.h"
#include "cli/report_command.h"
#include "cli/verify_command.h"

namespace moldwright::cli {

const std::vector<Command>& commands() {
    static const std::vector<Command> all = {
        checkCommand(), planeCommand(),  analyzeCommand(), pinsCommand(), designCommand(),
        moldCommand(),  verifyCommand(), reportCommand(),  infoCommand(),
    };
    return all;
}

} // namespace moldwright::cli

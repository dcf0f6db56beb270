// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "mold/mold.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace moldwright::cli {

/// The option --with, which names further parts of a mold.
void addTrayOption(CLI::App& app, std::vector<std::string>& parts);

/// The tray with further parts, each given as a project file or a folder that `design` wrote, with ":N" where
/// it is to have N cavities. Errors: as readTrayPart(), naming what was given.
[[nodiscard]] Result<Tray> withParts(Tray tray, const std::vector<std::string>& parts);

/// The parts' names and how many cavities each has, for people.
[[nodiscard]] std::string partsInWords(const std::vector<PartOfMold>& parts);

} // namespace moldwright::cli

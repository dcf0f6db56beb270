// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/mold_settings.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace moldwright::cli {

/// Options for pockets and plaque. What is not given stays as it is.
struct InsertOptions {
    /// Declares --pockets, --plaque and those that refine them.
    void declare(CLI::App& app);

    void apply(MoldSettings& settings) const;

private:
    std::optional<int> pockets;
    std::string pocketShape, pocketHalf, plaque;
    std::optional<double> pocketWidth, pocketLength, pocketDepth, pocketClearance, plaqueHeight, plaqueDepth;
};

} // namespace moldwright::cli

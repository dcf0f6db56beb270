// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/project.h"

#include <string>

namespace CLI {
class App;
}

namespace moldwright::cli {

/// Options that bring a file's numbers to millimetres.
struct SizeOptions {
    std::string units = "mm";
    double scale = 1;
    double size = 0; ///< longest side of the part, mm; 0: as the file has it

    /// Declares --units, --scale and --size on `app`.
    void declare(CLI::App& app);

    /// The file's numbers to millimetres: the unit, then the scale or the size asked for.
    [[nodiscard]] Placement placementFor(const IndexedMesh& source) const;
};

} // namespace moldwright::cli

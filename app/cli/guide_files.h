// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "design/design.h"

#include <filesystem>
#include <vector>

namespace moldwright::cli {

/// The pins of a JSON file, {"pins": [{"point": [x, y, z]}, …]}, in mm in the part's frame; what else a pin
/// carries (`pins` writes radius, kind, rank) is not read. A pin must lie in the part or on it. Errors:
/// BadInput, naming the file, the entry and what is wrong.
[[nodiscard]] Result<std::vector<Pin>> readPins(const std::filesystem::path& file, const IndexedMesh& part);

/// Importance per face of the part from a JSON file, {"regions": [{"centre": [x, y, z], "radius": r,
/// "weight": w}, {"faces": [f, …], "weight": w}, …]}: a region is the faces with their middle in a ball, mm,
/// or those named; where regions overlap the larger weight holds, elsewhere it is 1. Errors: BadInput, naming
/// the file, the entry and what is wrong; a region without a face too.
[[nodiscard]] Result<std::vector<double>> readWeights(const std::filesystem::path& file,
                                                      const IndexedMesh& part);

} // namespace moldwright::cli

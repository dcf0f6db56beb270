// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "mold/placed_feature.h"
#include "project/project.h"

#include <filesystem>
#include <string>
#include <vector>

namespace moldwright {

/// The pins of a JSON file, {"pins": [{"point": [x, y, z], "name": "left ear"}, …]}, in mm in the part's
/// frame; they need no name, and what else a pin carries (`pins` writes radius, kind, rank) is not read. A
/// pin must lie in the part or on it. Errors: BadInput, naming the file, the entry and what is wrong.
[[nodiscard]] Result<std::vector<NamedPin>> readPins(const std::filesystem::path& file,
                                                     const IndexedMesh& part);

/// The text of such a file.
[[nodiscard]] std::string pinsText(const std::vector<NamedPin>& pins);

/// What is important of a part, from a JSON file, {"regions": [{"name": "eye", "centre": [x, y, z],
/// "radius": r, "weight": w, "keep_within": d}, {"faces": [f, …], "weight": w}, …]}: a region is the faces
/// with their middle in a ball, mm, or those listed, whose "weight" may be a list too, one number for each.
/// Where regions overlap the larger weight holds, elsewhere it is 1. Without a name a region has its number;
/// without keep_within (mm) it is only measured. Errors: BadInput, naming the file, the entry and what is
/// wrong; a region without a face too.
[[nodiscard]] Result<std::vector<ImportantRegion>> readWeights(const std::filesystem::path& file,
                                                               const IndexedMesh& part);

/// The text of such a file: faces listed, one region a line.
[[nodiscard]] std::string weightsText(const std::vector<ImportantRegion>& regions);

/// What is to be placed by hand, from a JSON file, {"features": [{"kind": "key", "number": 1, "at": [x, y]},
/// …]}: that is how mold.json lists them, so one of its own serves too. Errors: BadInput, naming the file,
/// the entry and what is wrong.
[[nodiscard]] Result<PlacedFeatures> readPlaces(const std::filesystem::path& file);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/region_measure.h"

#include <string>
#include <vector>

namespace moldwright {

/// More makes the elastic energy's matrix useless.
inline constexpr double mostWeight = 65536;

/// A named part of the surface that is to keep its shape while the rest gives way.
struct ImportantRegion {
    std::string name;
    std::vector<int> faces;      ///< of the part, ascending
    std::vector<double> weights; ///< one for each of them: 1 (like the rest) to mostWeight
    double keepWithin = 0;       ///< mm that its points may move against each other; 0: not limited

    bool operator==(const ImportantRegion&) const = default;
};

/// The region after a stroke over `faces` (ascending): twice the weight where it has them, and 2 where they
/// are new to it.
[[nodiscard]] ImportantRegion heavier(const ImportantRegion& region, const std::vector<int>& faces);

/// The region after a stroke that erases: half the weight; a face that would weigh 1 leaves the region.
[[nodiscard]] ImportantRegion lighter(const ImportantRegion& region, const std::vector<int>& faces);

/// The region with one weight all over.
[[nodiscard]] ImportantRegion weighing(ImportantRegion region, double weight);

/// The largest weight in a region; 1 for one without faces.
[[nodiscard]] double heaviest(const ImportantRegion& region);

/// Importance of each face of the part: the largest weight of the regions it is in, else 1. Empty when no
/// face weighs more than 1.
[[nodiscard]] std::vector<double> faceWeights(const std::vector<ImportantRegion>& regions, int faceCount);

/// What a run is to measure.
[[nodiscard]] std::vector<KeptRegion> keptRegions(const std::vector<ImportantRegion>& regions);

/// Whether a region came through as it was to, as measured; true where it has no limit.
[[nodiscard]] bool keepsWithin(const ImportantRegion& region, const RegionMeasure& measure);

/// Whether the regions ask the same of a run: all but names and limits.
[[nodiscard]] bool weighAlike(const std::vector<ImportantRegion>& a, const std::vector<ImportantRegion>& b);

} // namespace moldwright

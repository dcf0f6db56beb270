// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <string>
#include <vector>

namespace moldwright {

/// A part of the surface whose shape is to be kept.
struct KeptRegion {
    std::string name;
    std::vector<int> faces; ///< of the part
    double within = 0;      ///< mm that its points may move against each other; 0: not limited, only measured

    bool operator==(const KeptRegion&) const = default;
};

/// How a region came through, wherever it went as a whole: after its own best rigid fit.
struct RegionMeasure {
    std::string name;
    double maxDistance = 0; ///< mm, of its points
    double rmsDistance = 0; ///< mm, root of the mean square
    double strain = 0;      ///< see SurfaceStrain::rms
    bool kept = true;       ///< no point moved farther than allowed

    bool operator==(const RegionMeasure&) const = default;
};

/// Measures regions. `before`: the surface that was bent, its points where they were before; `sourceFace`:
/// the face of the part that each of its faces is a piece of; `sourceVertex`: the point of it that each of
/// the cast's was.
[[nodiscard]] std::vector<RegionMeasure> measureRegions(const std::vector<KeptRegion>& regions,
                                                        const IndexedMesh& before,
                                                        const std::vector<int>& sourceFace,
                                                        const IndexedMesh& cast,
                                                        const std::vector<int>& sourceVertex);

} // namespace moldwright

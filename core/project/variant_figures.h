// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/project.h"

#include <Eigen/Core>

#include <optional>

namespace moldwright {

/// What variants are chosen by: how a variant's cast came out, and what its mold takes.
struct VariantFigures {
    bool castable = false;                    ///< proved, on the cast's coordinates
    double worstDraftDegrees = 0;             ///< of any face
    std::optional<double> strain;             ///< SurfaceStrain::rms; none for files of old
    double largestDistance = 0;               ///< mm to the part, after the best rigid fit
    std::optional<double> rmsDistance;        ///< mm, the same; none for files of old
    double filledVolume = 0;                  ///< mm³
    std::optional<Eigen::Vector3d> blockSize; ///< mm; none where no mold can be built about the cast
    int steps = 0;                            ///< of the run; 0 where nobody counted them
};

/// Measures a variant. Precondition: it has a cast.
[[nodiscard]] VariantFigures variantFigures(const IndexedMesh& part, const Variant& variant);

} // namespace moldwright

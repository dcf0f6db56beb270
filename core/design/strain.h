// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

/// How the surface was strained: what the eye sees of a deformation besides its size.
struct SurfaceStrain {
    double rms = 0;         ///< √(mean over the area of Σ (σ − 1)²), σ the two principal stretches of a face
    double stretchLow = 1;  ///< the 1st percentile, by area, of the smaller principal stretches
    double stretchHigh = 1; ///< the 99th percentile, by area, of the larger ones
    double roughness = 1;   ///< rms dihedral angle of the cast over that of the shape before
};

/// √(Σ (σ − 1)²) per face of `cast`, σ the two principal stretches from where its corners were; `before`:
/// n×3, where each point of cast was. 0 for faces without area before.
[[nodiscard]] std::vector<double> faceStrains(const Points& before, const IndexedMesh& cast);

/// Strain from `before` to `cast`; `sourceVertex`: the point of `before` that each point of cast was. Faces
/// that were needles before, a thousandth as high as long, are left out: what they would measure is how the
/// clean-up joined their points.
[[nodiscard]] SurfaceStrain surfaceStrain(const IndexedMesh& before, const IndexedMesh& cast,
                                          const std::vector<int>& sourceVertex);

} // namespace moldwright

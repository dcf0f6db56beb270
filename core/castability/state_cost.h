// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/energy.h"
#include "castability/face_arrays.h"

#include <span>
#include <vector>

namespace moldwright {

/// What a mold state costs on a surface. Units of the surface's coordinates.
struct StateCost {
    double energy = 0;        ///< as castabilityEnergy()
    double volumeAbove = 0;   ///< enclosed on side 1, when the surface is closed
    double violatingArea = 0; ///< of the pieces below the draft
    double worstSine = 1;     ///< smallest N·d of any piece
};

/// Derivatives of a volume with respect to the plane's normal (in ℝ³, along the unit sphere) and offset.
struct VolumeGradient {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    double offset = 0;
};

/// Cost of one state, in vector code: agrees with castabilityEnergy() to 1e-12, has the same bits for any
/// vector width and any number of threads.
[[nodiscard]] StateCost stateCost(const FaceArrays& faces, const MoldState& state, double tau);

/// The same with the derivatives of energy and volume.
StateCost stateCost(const FaceArrays& faces, const MoldState& state, double tau, StateGradient& energy,
                    VolumeGradient& volume);

/// Cost of many states at once: blocks of faces stay in the processor's cache for all of them. Each is what
/// stateCost() gives.
[[nodiscard]] std::vector<StateCost> stateCosts(const FaceArrays& faces, std::span<const MoldState> states,
                                                double tau);

} // namespace moldwright

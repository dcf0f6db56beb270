// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

namespace moldwright {

/// Derivatives of the castability energy with respect to plane and directions, as plain ℝ³ derivatives:
/// project them to the unit sphere where that is wanted.
struct StateGradient {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< ∂E/∂n
    double offset = 0;                                ///< ∂E/∂o
    Eigen::Vector3d d1 = Eigen::Vector3d::Zero();
    Eigen::Vector3d d2 = Eigen::Vector3d::Zero();
};

/// The castability energy ½ ∫ min(N·d − τ, 0)² dA, faces that cross the plane counted as two pieces.
/// Units: area. [Stein 2019], Eq. (2) and Appendix A.1. Zero exactly when the mesh is removable with
/// tolerance τ. Degenerate faces (zero area) count nothing. Deterministic for any number of threads.
[[nodiscard]] double castabilityEnergy(const IndexedMesh& mesh, const MoldState& state, double tau);

/// The same with its derivatives with respect to the state.
double castabilityEnergy(const IndexedMesh& mesh, const MoldState& state, double tau,
                         StateGradient& gradient);

/// The same with its derivatives with respect to the vertices, n×3. Eq. (7), and Eq. (8) with its factor
/// corrected to 1/(2A).
double castabilityEnergy(const IndexedMesh& mesh, const MoldState& state, double tau, Points& gradient);

/// How a triangle is parted by the plane: the share of its area on side 1, and the share's derivatives with
/// respect to the three corners' signed distances.
struct PartedArea {
    double share1 = 0;
    Eigen::Vector3d derivative = Eigen::Vector3d::Zero();
};

/// Share of a triangle's area with positive distance. Corners on the plane belong to neither side; a triangle
/// wholly on the plane is put on side 1 when `flatSide` is 1, else on side 2. [Stein 2019], Appendix A.1.
[[nodiscard]] PartedArea partArea(const Eigen::Vector3d& distances, int flatSide);

} // namespace moldwright

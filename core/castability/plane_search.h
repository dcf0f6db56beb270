// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

/// What a search for parting planes may do.
struct PlaneSearch {
    int count = 6;      ///< K distinct planes asked for
    int samples = 1000; ///< random planes tried before local refinement
    double draftDegrees = 1;
    double maxTiltDegrees = 30;
    bool normalDirections = false; ///< keep d1 = n, d2 = −n
    unsigned seed = 1;
};

/// A parting plane with its directions and how good it is.
struct PlaneCandidate {
    MoldState state;
    double energy = 0; ///< Eq. (2), scale-free
    double violatingAreaFraction = 0;
    double worstDraftDegrees = 0;
    double smallerVolumeFraction = 0; ///< share of the volume on the smaller side, 0 for a flat-backed part
};

/// The best distinct parting planes of a closed mesh, best first: random sampling, then local refinement of
/// plane and directions by L-BFGS on Eq. (2). [Stein 2019], Section 6.3. Deterministic for a given seed.
[[nodiscard]] std::vector<PlaneCandidate> findPlanes(const IndexedMesh& mesh, const PlaneSearch& search,
                                                     const Task& task = {});

/// The parting planes that lie on a flat back: a plane face patch of at least 1 % of the surface with all of
/// the part on one side of it; n looks into the part, so that side 2 is the flat face alone.
[[nodiscard]] std::vector<PartingPlane> flatBackPlanes(const IndexedMesh& mesh);

/// Derivatives of a volume with respect to the plane's normal (in ℝ³) and offset.
struct VolumeGradient {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    double offset = 0;
};

/// Volume on side 1 of the plane, mm³, of a closed mesh; and its derivatives if wanted.
[[nodiscard]] double volumeAbove(const IndexedMesh& mesh, const PartingPlane& plane,
                                 VolumeGradient* gradient = nullptr);

} // namespace moldwright

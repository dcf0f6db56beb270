// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/direction_limits.h"
#include "castability/face_arrays.h"
#include "castability/mold_state.h"

#include <vector>

namespace moldwright {

/// The faces of one side as a direction sees them: unit normals and areas, eight side by side; lanes with
/// area 0 belong to the other side. A face that crosses the plane is on both with its share of the area.
class SideFaces {
public:
    static constexpr int L = FaceArrays::kLanes;
    struct alignas(64) Batch {
        double normal[3][L];
        double area[L];
    };

    /// Energy against a direction d, ½ Σ a min(N·d − τ, 0)², with its derivatives in ℝ³. [Stein 2019], Eq.
    /// (2).
    struct Energy {
        double value = 0;
        Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
        Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
    };
    [[nodiscard]] Energy energy(const Eigen::Vector3d& d, double tau) const;

    std::vector<std::vector<Batch>> blocks; ///< in the order of the faces
};

/// The faces of both sides of a plane.
struct PartedFaces {
    SideFaces side1;
    SideFaces side2;
};
[[nodiscard]] PartedFaces partFaces(const IndexedMesh& mesh, const PartingPlane& plane);

/// Directions of least energy for a given plane, each in the cap that the limits leave it: Newton's method
/// for d ∝ m + T·u in the disc |u| ≤ tan(cap's radius), m the cap's middle. [Stein 2019], Section 5.1.
/// Precondition: the limits allow directions at the plane.
[[nodiscard]] Directions bestDirections(const IndexedMesh& mesh, const PartingPlane& plane,
                                        double draftDegrees, const DirectionLimits& limits);

} // namespace moldwright

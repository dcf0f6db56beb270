// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

/// The faces of one side as a direction sees them: unit normals and areas, as structure of arrays.
struct SideFaces {
    std::vector<double> nx, ny, nz, area;

    void add(const Eigen::Vector3d& N, double a);
};

/// Faces of both sides; a face that crosses the plane is in both with its share of the area.
struct PartedFaces {
    SideFaces side1;
    SideFaces side2;
};
[[nodiscard]] PartedFaces partFaces(const IndexedMesh& mesh, const PartingPlane& plane);

/// Energy of one side against direction d: ½ Σ a min(N·d − τ, 0)²; its gradient in ℝ³ if wanted. [Stein
/// 2019], Eq. (2).
[[nodiscard]] double sideEnergy(const SideFaces& faces, const Eigen::Vector3d& d, double tau,
                                Eigen::Vector3d* gradient = nullptr);

/// A direction within a cone about `axis`, as two free numbers: d = normalize(axis + tan(tilt)·c/√(1+|c|²)),
/// c in the plane of `planeAxes(axis)`. Every c is allowed, so d·axis > 0 and the tilt cap hold by
/// construction.
class ConeDirection {
public:
    ConeDirection(const Eigen::Vector3d& axis, double maxTiltDegrees);

    [[nodiscard]] Eigen::Vector3d direction(const Eigen::Vector2d& c) const;
    /// Gradient with respect to c from the gradient g with respect to d.
    [[nodiscard]] Eigen::Vector2d pullBack(const Eigen::Vector2d& c, const Eigen::Vector3d& g) const;
    /// The c of a direction; one outside the cone is brought to its rim.
    [[nodiscard]] Eigen::Vector2d coordinates(const Eigen::Vector3d& d) const;

private:
    Eigen::Vector3d m_axis;
    Eigen::Matrix<double, 3, 2> m_tangents;
    double m_reach; ///< tan of the largest tilt
};

/// Directions of least energy for a given plane, within the tilt cap. [Stein 2019], Section 5.1.
[[nodiscard]] Directions bestDirections(const IndexedMesh& mesh, const PartingPlane& plane,
                                        double draftDegrees, double maxTiltDegrees);

} // namespace moldwright

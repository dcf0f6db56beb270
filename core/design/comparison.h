// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/design.h"
#include "mesh/indexed_mesh.h"

#include <Eigen/Geometry>

#include <vector>

namespace moldwright {

/// How far `cast` is from `part`. `sourceVertex`: the point of `parted` that each point of cast was; `parted`
/// is the undeformed part with its parting line. The best rigid fit is that of the corresponding points;
/// distances are from surface to surface, both ways, over the part's diagonal.
[[nodiscard]] Change measureChange(const IndexedMesh& part, const IndexedMesh& parted,
                                   const IndexedMesh& cast, const std::vector<int>& sourceVertex);

/// Distances between cast and part after the best rigid fit, as measureChange() takes them, mm: per face of
/// each, the mean of its corners' distances to the other surface. `before`: n×3, where each point of cast
/// was.
struct Deviation {
    std::vector<double> ofCast;
    std::vector<double> ofPart;
};
[[nodiscard]] Deviation deviation(const IndexedMesh& part, const IndexedMesh& cast, const Points& before);

/// The root of the mean square, over both surfaces, of what deviation() is the mean of, mm.
[[nodiscard]] double rmsDistance(const IndexedMesh& part, const IndexedMesh& cast, const Points& before);

/// Two casts of one part laid over each other, each as its part fits best: per face of `cast`, the mean of
/// its corners' distances to `other`, mm. `before`, `otherBefore`: n×3, where the points of each were in the
/// part; empty: they lie as they are.
[[nodiscard]] std::vector<double> castDifference(const IndexedMesh& cast, const Points& before,
                                                 const IndexedMesh& other, const Points& otherBefore);

/// How the limbs of the undeformed part came through: from each tip to where it joins the body, where the
/// surface around the tip widens abruptly. `tips`: points near which the tips lie; empty: found on the part
/// (limbTips()).
[[nodiscard]] std::vector<LimbMeasure> measureLimbs(const IndexedMesh& parted, const IndexedMesh& cast,
                                                    const std::vector<int>& sourceVertex,
                                                    const std::vector<Eigen::Vector3d>& tips);

/// The rigid motion that takes the rows of `from` nearest to those of `to` in the least squares sense.
/// [Kabsch 1976]
[[nodiscard]] Eigen::Isometry3d bestRigidFit(const Points& from, const Points& to);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace moldwright::scene {

/// Where the plane meets the surface, as segments to be drawn, mm. Edges that lie in the plane between the
/// two sides count too, so that an inserted parting line is found again.
[[nodiscard]] std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>
partingSegments(const IndexedMesh& mesh, const PartingPlane& plane);

} // namespace moldwright::scene

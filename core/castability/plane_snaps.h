// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <array>
#include <optional>

namespace moldwright {

// Parting planes that snap to something. Each keeps its sides: of the two normals the one nearer to that of
// `like` is taken.

/// The plane square to an axis (unit) through a point, mm.
[[nodiscard]] PartingPlane squareTo(const Eigen::Vector3d& axis, const Eigen::Vector3d& through,
                                    const PartingPlane& like);

/// The plane through three points, mm; none where they lie on a line, to a millionth of their distances.
[[nodiscard]] std::optional<PartingPlane> planeThrough(const std::array<Eigen::Vector3d, 3>& points,
                                                       const PartingPlane& like);

/// The plane of a face; none where it is a line.
[[nodiscard]] std::optional<PartingPlane> planeOfFace(const IndexedMesh& mesh, int face,
                                                      const PartingPlane& like);

} // namespace moldwright

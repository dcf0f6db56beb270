// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/tet_mesh.h"

namespace moldwright {

/// Makes a point strictly inside a tetrahedron mesh a point of it, the last one: the tetrahedron that holds
/// it and those across faces that it comes too near to give way to tetrahedra between it and what bounds them
/// ([Watson 1981]). Faces of the mesh's surface stay. Returns false, with nothing changed, where the point
/// lies in no tetrahedron or cannot be reached without a tetrahedron that is all but flat.
bool insertPoint(TetMesh& tets, const Eigen::Vector3d& point);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/tet_mesh.h"

#include <array>

namespace moldwright::test {

/// A solid with its surface: what TetGen would give, built by hand. Surface points first.
struct Solid {
    TetMesh tets;
    Triangles F; ///< the faces that only one tetrahedron has, outward
};

/// Box from lo to hi in cells[0] × cells[1] × cells[2] cells, six tetrahedra each.
Solid solidBox(const Eigen::Vector3d& lo, const Eigen::Vector3d& hi, const std::array<int, 3>& cells);

} // namespace moldwright::test

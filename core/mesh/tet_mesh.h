// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

namespace moldwright {

/// Tetrahedra, one a row: indices of four points, positive volume: (b−a)·((c−a)×(d−a)) > 0. k×4.
using Tetrahedra = Eigen::Matrix<int, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// A solid as tetrahedra. The points of the surface it was made from come first and keep their order, so that
/// surface vertex v is tet vertex v.
struct TetMesh {
    Points V;     ///< n×3
    Tetrahedra T; ///< k×4
};

} // namespace moldwright

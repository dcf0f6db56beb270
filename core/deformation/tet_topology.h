// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/tet_mesh.h"

#include <array>
#include <vector>

namespace moldwright {

/// The tetrahedron across each face of each tetrahedron (face k is opposite corner k), −1 where there is
/// none.
[[nodiscard]] std::vector<std::array<int, 4>> tetNeighbours(const Tetrahedra& T);

/// The tetrahedron that has each surface face, −1 where there is none.
[[nodiscard]] std::vector<int> tetsBehindFaces(const Tetrahedra& T, const Triangles& F);

/// Importance of each tetrahedron: that of the heaviest face of F on it, at least 1. `faceWeights`: per face
/// of F. [Stein 2019], Section 6.2.
[[nodiscard]] std::vector<double> tetWeights(const Tetrahedra& T, const Triangles& F,
                                             const std::vector<double>& faceWeights);

/// How many tetrahedra are turned inside out at positions V.
[[nodiscard]] int invertedCount(const Tetrahedra& T, const Eigen::Ref<const Eigen::MatrixXd>& V);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <Eigen/Core>

#include <vector>

namespace moldwright::scene {

/// A mesh ready to be drawn smooth where it is smooth and sharp at creases: a vertex on a crease is split
/// into one point per normal. Faces keep their order.
struct ShadedMesh {
    Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> points;
    Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> normals;
    Triangles faces;
};

/// `mesh` with normals that average the faces about a vertex that lie within `creaseDegrees` of each other.
/// O(m).
[[nodiscard]] ShadedMesh shade(const IndexedMesh& mesh, double creaseDegrees = 40);

} // namespace moldwright::scene

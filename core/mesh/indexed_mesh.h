// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <memory>

namespace moldwright {

/// Points, one a row. n×3.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Triangles, one a row: indices of three points, counter-clockwise seen from outside. m×3.
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// A triangle mesh as plain arrays: what crosses the boundaries between rooms, programs and threads.
struct IndexedMesh {
    Points V;    ///< n×3, mm (or the file's unit before it is known)
    Triangles F; ///< m×3

    [[nodiscard]] int vertexCount() const { return static_cast<int>(V.rows()); }
    [[nodiscard]] int faceCount() const { return static_cast<int>(F.rows()); }
    [[nodiscard]] Eigen::Vector3d point(int v) const { return V.row(v).transpose(); }
    [[nodiscard]] Eigen::Vector3d corner(int f, int k) const { return V.row(F(f, k)).transpose(); }
};

/// A mesh that is shared and never changes: how documents and jobs hold heavy geometry.
using SharedMesh = std::shared_ptr<const IndexedMesh>;

} // namespace moldwright

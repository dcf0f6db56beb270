// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace moldwright {

/// Answers how much of a solid lies over a point along a direction: faces that look along d, projected along
/// it and sorted into a plane grid. Built in O(m), asked in O(1) on even meshes.
class Overhang {
public:
    /// `faces`: the faces of `mesh` to consider. The mesh must outlive this.
    Overhang(const IndexedMesh& mesh, const std::vector<int>& faces, const Eigen::Vector3d& d);

    /// Way from p along d to the outermost of the faces over it, mm; 0 when there is none.
    [[nodiscard]] double above(const Eigen::Vector3d& p) const;

private:
    [[nodiscard]] std::array<int, 2> cellOf(const Eigen::Vector2d& q) const;

    const IndexedMesh& m_mesh;
    Eigen::Vector3d m_d;
    Eigen::Matrix<double, 2, 3> m_axes;
    Eigen::Vector2d m_low;
    double m_cell = 1;
    int m_columns = 1;
    int m_rows = 1;
    std::vector<std::vector<int>> m_cells;
};

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace moldwright {

/// Faces of a mesh as seen along a direction d: projected along it and sorted into a plane grid. Built in
/// O(m), asked in O(1) on even meshes.
class FacesAlong {
public:
    /// A face that the line through a point along d meets.
    struct Crossing {
        int face = -1;
        double way = 0;     ///< mm from the point along d; negative: behind it
        bool along = false; ///< the face looks along d: there the line leaves a solid
    };

    /// `faces`: the faces of `mesh` to consider; those that d runs along are passed over. The mesh must
    /// outlive this.
    FacesAlong(const IndexedMesh& mesh, const std::vector<int>& faces, const Eigen::Vector3d& d);

    /// All faces met by the line through p along d, in no particular order, into `found`.
    void crossings(const Eigen::Vector3d& p, std::vector<Crossing>& found) const;

private:
    [[nodiscard]] std::array<int, 2> cellOf(const Eigen::Vector2d& q) const;
    void sortIntoCells(const std::vector<int>& seen);

    const IndexedMesh& m_mesh;
    Eigen::Vector3d m_d;
    Eigen::Matrix<double, 2, 3> m_axes;
    Eigen::Vector2d m_low;
    double m_cell = 1;
    int m_columns = 1;
    int m_rows = 1;
    std::vector<std::size_t> m_first; ///< by cell, and one more: where its faces begin
    std::vector<int> m_faces;         ///< of all cells, one after the other
};

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/faces_along.h"

namespace moldwright {

/// Answers how much of a solid lies over a point along a direction. Built in O(m), asked in O(1) on even
/// meshes.
class Overhang {
public:
    /// `faces`: the faces of `mesh` to consider. The mesh must outlive this.
    Overhang(const IndexedMesh& mesh, const std::vector<int>& faces, const Eigen::Vector3d& d);

    /// Way from p along d to the outermost of the faces over it, mm; 0 when there is none.
    [[nodiscard]] double above(const Eigen::Vector3d& p) const;

private:
    FacesAlong m_faces; ///< those that look along d
};

} // namespace moldwright

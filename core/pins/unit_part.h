// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

namespace moldwright {

/// A part in a pose of its own: about the centre of its surface, along the principal axes of its surface, its
/// farthest point at 1/2, coordinates rounded to 1e-7. So what is computed from it is the same, to the bit,
/// however the part was turned, moved or scaled, unless its axes are not its own (a ball's, a cube's).
struct UnitPart {
    IndexedMesh mesh;
    Eigen::Vector3d centre;
    Eigen::Matrix3d axes; ///< as columns; right-handed
    double size = 1;      ///< mm per unit

    explicit UnitPart(const IndexedMesh& part);

    /// A point of the unit part in the part's frame.
    [[nodiscard]] Eigen::Vector3d toPart(const Eigen::Vector3d& p) const { return centre + size * axes * p; }
};

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "mold/block.h"

#include <string>
#include <vector>

namespace moldwright {

/// One hollow of the mold, for measuring the steel about it. Hollows that share a joint are one another's
/// neighbours by design and are not compared.
struct Hollow {
    std::string name;
    SharedMesh mesh;                                  ///< in coordinates of its own
    Eigen::Vector2d offset = Eigen::Vector2d::Zero(); ///< where it stands, mm
    std::vector<int> joints;                          ///< numbers of the joints it takes part in
    bool opensOutside = false;                        ///< its distance from the block's faces means nothing
};

/// Steel at its thinnest, mm, between two hollows or one and the outside of the block.
struct ThinSteel {
    double thickness = 0;
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< mm, mold's frame: on the first hollow
    std::string first;
    std::string second; ///< "outside" for the block's faces
};

/// The thinnest steel of each pair of names, thinnest first. Distances from the points of each hollow to the
/// faces of the other, both ways: exact where one of the nearest two places is a point of its mesh, as
/// it is unless two edges pass each other askew; then it is too large by less than their faces are wide.
/// Pairs further apart than `furthest` mm are left out.
[[nodiscard]] std::vector<ThinSteel> thinnestSteel(const std::vector<Hollow>& hollows, const Block& block,
                                                   double furthest);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <Eigen/Core>

#include <vector>

namespace moldwright {

/// A place where air stays while a cavity fills: a high point from which every way out leads down first.
struct AirTrap {
    int point = -1;          ///< of the mesh: the high point
    double level = 0;        ///< mm along `up`: above it the air cannot leave
    double volume = 0;       ///< mm³ above that level
    std::vector<int> points; ///< the mesh's points above the level, the high point first
};

/// The traps of a cavity that fills from below and drains at `drain`, a point of the mesh (the spout's or a
/// runner's): local high points of the closed surface `cast` along `up` (unit), each with what lies above the
/// pass over which it joins a higher one, or above the drain. Traps below `smallest` mm³ are left out. The
/// passes are those of the surface; in a ring that stands upright the solid's own are lower, never higher, so
/// no trap is missed. Largest first; O(m log m) and the traps' own size.
[[nodiscard]] std::vector<AirTrap> airTraps(const IndexedMesh& cast, const Eigen::Vector3d& up, int drain,
                                            double smallest);

/// Volume of the air above `level` in a trap: what is left when it is vented there, mm³.
[[nodiscard]] double airAbove(const IndexedMesh& cast, const Eigen::Vector3d& up, const AirTrap& trap,
                              double level);

} // namespace moldwright

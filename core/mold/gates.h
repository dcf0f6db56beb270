// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "features/air_traps.h"
#include "mesh/indexed_mesh.h"
#include "mold/layout.h"

#include <vector>

namespace moldwright {

/// Where a cavity is filled: the highest point of the parting line of one of its solids.
struct Gate {
    int point = -1;    ///< of the kind's cast
    PlanShape outline; ///< the parting curve that the point lies on
    double drop = 0;   ///< mm below the point at which a channel as wide as asked for lies inside the outline
};

/// The gates of a cavity that is filled along `up` (a unit vector in the plane), one for each of its solids.
/// `width` mm is the channel's.
[[nodiscard]] std::vector<Gate> gatesOf(const IndexedMesh& cast, const SideLabels& labels,
                                        const Eigen::Vector2d& up, double width);

/// The traps of all solids of a cavity that fills along `up` (unit), each drained at one of the points
/// `drains`; smaller ones than `smallest` mm³ left out.
[[nodiscard]] std::vector<AirTrap> trapsOf(const IndexedMesh& cast, const std::vector<int>& drains,
                                           const Eigen::Vector3d& up, double smallest);

/// The gates' points.
[[nodiscard]] std::vector<int> drainsOf(const std::vector<Gate>& gates);

/// Of the four quarter turns the one with which, when +y is up, the fewest gates `width` mm wide have another
/// solid of the cavity over them, and of those the one that traps least air; 0 to 3. The smallest among
/// equals.
[[nodiscard]] int bestQuarterTurn(const IndexedMesh& cast, const SideLabels& labels, double width,
                                  double smallestTrap);

/// The mesh turned by quarters about z, counter-clockwise; exact.
[[nodiscard]] IndexedMesh quarterTurned(const IndexedMesh& mesh, int quarters);

} // namespace moldwright

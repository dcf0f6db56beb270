// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "castability/mold_state.h"
#include "features/air_traps.h"
#include "features/plan_shape.h"
#include "mesh/indexed_mesh.h"

#include <optional>
#include <vector>

namespace moldwright {

/// A parting curve of a cavity, seen along the plane's normal.
struct CavityOutline {
    PlanShape shape;
    std::vector<int> points; ///< of the cast, in the shape's order
    int solid = 0;           ///< the piece of the cast that it belongs to
};
/// All of them, in the order of their smallest points; none where curves touch themselves.
[[nodiscard]] std::vector<CavityOutline> outlinesOf(const IndexedMesh& cast, const SideLabels& labels);

/// Where a cavity is filled from above (+y): a place on the parting line of one of its solids.
struct Gate {
    int point = -1;                                ///< of the cast: the one at the tip, or the nearest
    Eigen::Vector2d tip = Eigen::Vector2d::Zero(); ///< where its axis meets the outline, mm
    PlanShape outline;                             ///< the parting curve that the tip lies on
    double drop = 0;  ///< mm below the tip at which a channel as wide as asked for lies inside the outline
    double exit = 0;  ///< y above which it lies outside
    int number = 0;   ///< of the kind's, or of all spouts where gates are spouts
    double width = 0; ///< mm, of the channel: as wide as asked for, or as the cavity has room there
};

/// The gates of a cavity, one for each of its solids, at the highest point of its parting line; `width` mm
/// is the channel's, less where the cavity itself is not wider.
[[nodiscard]] std::vector<Gate> gatesOf(const std::vector<CavityOutline>& outlines, double width);

/// The gate of one solid (counted as gatesOf() does) with its axis at `x`. Errors: Impossible, with the
/// places that a gate could have.
[[nodiscard]] Result<Gate> gateAt(const std::vector<CavityOutline>& outlines, int gate, double x,
                                  double width);

/// The height that the outlines reach within a channel about `x`, of those parts not lower than `low`.
[[nodiscard]] double exitOf(const PlanShape& outline, double x, double width, double low);

/// Where the outlines are highest over `x`; none where that is at none of `points` (of the cast).
[[nodiscard]] std::optional<Eigen::Vector2d> topOver(const std::vector<CavityOutline>& outlines, double x,
                                                     const std::vector<int>& points);

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

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fill/choice_mesh.h"
#include "fill/fill.h"

#include <vector>

namespace moldwright {

/// A part of what filling a part changes, that can be filled or left on its own: an undercut that hangs
/// together, or, where only some of it is needed, what is and what is not.
struct FillRegion {
    int side = 0;          ///< 1 or 2; 0: it reaches through the plane
    Eigen::Vector3d place; ///< a point of the surface that would vanish, plane's frame
    double size = 0;       ///< diagonal of its box, mm
    double volume = 0;     ///< what would be filled in, mm³
    bool needed = false;   ///< without it the topological certificate fails; see FillPlan
};

/// What filling would do, region by region. Where the filled part and the part agree there is nothing to
/// choose; everything else falls into regions.
struct FillPlan {
    std::vector<FillRegion> regions; ///< the largest volume first
    PartedMesh part;                 ///< on the exact grid of fill(); plane's frame
    FilledPart filled;               ///< with all regions chosen
    ChoiceMesh choices;              ///< between part and filled; its regions are those above

    /// The regions marked needed: with them alone the topological certificate holds. Undercuts that it asks
    /// for are divided at their necks, and what can be left of them is left, the largest first; other choices
    /// may serve too.
    [[nodiscard]] std::vector<int> needed() const;
};

/// Plans the filling of a parted mesh. `part` and directions in the plane's frame. Errors: those of fill().
[[nodiscard]] Result<FillPlan> planFill(const PartedMesh& part, const Directions& directions,
                                        const Task& task = {});

/// The plan with the larger undercuts that can be left divided at their necks too, so that those of one limb
/// can be chosen without those of the next. Walls between neighbours stand along the direction.
[[nodiscard]] FillPlan divided(FillPlan plan, const Directions& directions, const Task& task = {});

/// The part with the chosen regions filled and all others as they were; these keep their undercuts. What a
/// chosen region cannot be filled without is filled too, if it is little. Checked as fill() checks. Errors:
/// Internal where surfaces that were to stay cross those that filling makes: the regions beside must be
/// chosen besides.
[[nodiscard]] Result<FilledPart> fillChosen(const FillPlan& plan, const std::vector<int>& chosen);

/// Fills as little as the topological certificate asks for, and what that drags along.
[[nodiscard]] Result<FilledPart> minimalFill(const FillPlan& plan);

} // namespace moldwright

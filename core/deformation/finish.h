// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "deformation/clean_up.h"

#include <functional>

namespace moldwright {

/// What the finish is to reach.
struct FinishGoal {
    Directions directions;   ///< in the plane's frame
    double draftDegrees = 1; ///< required; aimed at one degree higher, since the hinge nears its goal slowly
    double resolution = 0;   ///< size of a coordinate's rounding step (a float ulp) in the surface's units
    int rounds = 10;
    std::vector<double> importance = {}; ///< per point before clean-up (sourceVertex); empty: all 1
    bool keepDetail = false; ///< the surface followed a coarse one, many faces miss their draft by little:
                             ///< motion comes before clean-up, which costs detail wherever a face is short
};

/// Brings a nearly castable labelled surface to its draft: rounds of minimising the castability energy over
/// the points with a vanishing share of elasticity, then clean-up of what no motion can mend. Labels stay;
/// points of the parting line stay in the plane and the line stays simple. The last step of Algorithm 1 in
/// [Stein 2019], on a surface whose parting line is inserted. After the first rounds only the surroundings of
/// the faces that are short move; where what is left is stuck, it begins again in the other order. `watch`,
/// if set, sees every round. Returns whether every face has its draft and
/// none is folded.
bool finishSurface(LabelledSurface& surface, const FinishGoal& goal, const Task& task,
                   const std::function<void(const LabelledSurface&)>& watch);

} // namespace moldwright

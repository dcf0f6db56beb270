// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "deformation/clean_up.h"
#include "deformation/labelled_problem.h"

#include <vector>

namespace moldwright {

/// A piece of a labelled surface to be worked on alone: its rim stands fixed, and so do all points of the
/// parting line that lie beyond it, for the line is to stay simple.
struct FinishRegion {
    LabelledBody body;       ///< a shell; every face its own, in the order of `faces`
    std::vector<int> faces;  ///< of the surface, ascending
    std::vector<int> points; ///< of the surface, per point of the body
};

/// The faces within `rings` rings of neighbours of those given (1 per face of the surface), as a body of
/// their own. `importance`: per point before clean-up (sourceVertex); a face has the least of its corners';
/// empty: all 1.
[[nodiscard]] FinishRegion regionAround(const LabelledSurface& surface, std::vector<char> faces, int rings,
                                        const Directions& directions,
                                        const std::vector<double>& importance = {});

/// The whole surface.
[[nodiscard]] FinishRegion wholeRegion(const LabelledSurface& surface, const Directions& directions,
                                       const std::vector<double>& importance = {});

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "deformation/clean_up.h"
#include "design/parting.h"

#include <functional>
#include <vector>

namespace moldwright {

/// What the deformation of a parted solid is to respect.
struct ShapeGoal {
    double draftDegrees = 1;
    std::vector<double> faceWeights; ///< importance per face of the part; empty: all 1
    double resolution = 0;           ///< rounding step of the coordinates to be written, mm
    std::function<bool()> finishNow; ///< as in DesignRequest
};

/// Sees the surface (working frame) as it changes; the string names the stage.
using ShapeWatch = std::function<void(const char* stage, const LabelledSurface&)>;

/// A deformed surface in the working frame, and what it took.
struct CastableShape {
    LabelledSurface surface;
    bool reached = false; ///< every face has its draft
    int iterations = 0;
};

/// Bends a parted solid until its faces have their draft: one elastic minimisation with a growing castability
/// term, so that the shape stays related to the original throughout, then the labelled finish. See
/// ARCHITECTURE.md, "From part to cast". Cancelled tasks end early with what was reached.
[[nodiscard]] CastableShape bendToCastable(const PartedSolid& solid, const ShapeGoal& goal, const Task& task,
                                           const ShapeWatch& watch);

} // namespace moldwright

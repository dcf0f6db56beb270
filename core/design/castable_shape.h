// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "deformation/clean_up.h"
#include "design/parting.h"

#include <functional>
#include <vector>

namespace moldwright {

/// What the deformation of a parted part is to respect.
struct ShapeGoal {
    double draftDegrees = 1;
    Directions directions;             ///< part frame
    std::vector<double> faceWeights;   ///< importance per face of the part; empty: all 1
    std::function<bool()> enough = {}; ///< asked after every step; true ends the bending; may be empty
    bool thorough = false;             ///< every round to its end: slower, and limbs keep a little more
    /// Directions (part frame) for a bent surface (working frame), asked before every round but the first;
    /// empty: they stay.
    std::function<Directions(const LabelledSurface&)> follow = {};
};

/// Sees the surface (working frame) as it changes; the string names the stage.
using ShapeWatch = std::function<void(const char* stage, const LabelledSurface&)>;

/// A deformed surface in the working frame, and what it took.
struct BentShape {
    LabelledSurface surface;
    int iterations = 0;
    bool followed = false;         ///< its surface followed a stand-in's
    std::vector<PlacedPin> pins{}; ///< where those inside have come to; surfacePoint: of the part
    Points points{}; ///< of all that was bent, tetrahedra and stand-in included, and in which round of its
    int round = 0;   ///< bending: to go on from
};

/// The surface of a part with its parting line inserted, its points at X (n×3, working frame).
[[nodiscard]] LabelledSurface surfaceAt(const PartedPart& part, const Points& X);

/// Importance of each face of a parted part: its source's (`faceWeights`: per face of the part), 1 where
/// filling made it; and of each point, the most of its faces'. Empty where there are no weights.
[[nodiscard]] std::vector<double> importanceOfFaces(const PartedPart& part,
                                                    const std::vector<double>& faceWeights);
[[nodiscard]] std::vector<double> importanceOfPoints(const PartedPart& part,
                                                     const std::vector<double>& faceWeights);

/// Whether every face of the part has its draft already: such a part stays as it is.
[[nodiscard]] bool passesAlready(const PartedPart& part, double draftDegrees);

/// Bends a parted solid until its faces nearly have their draft: one elastic minimisation with a growing
/// castability term, so that the shape stays related to the original throughout. See ARCHITECTURE.md, "From
/// part to cast". Cancelled tasks end early with what was reached. `from`: what an earlier bending of the
/// same solid, for another goal, is to be gone on with; null: at rest.
[[nodiscard]] BentShape bend(const PartedSolid& solid, const ShapeGoal& goal, const Task& task,
                             const ShapeWatch& watch, const BentShape* from = nullptr);

/// The labelled finish: brings a bent surface to its draft. `resolution`: rounding step of the coordinates to
/// be written, mm; faces that it could spoil are cleaned away. Returns whether every face has its draft.
[[nodiscard]] bool finish(BentShape& bent, const PartedPart& part, const ShapeGoal& goal, double resolution,
                          const Task& task, const ShapeWatch& watch);

} // namespace moldwright

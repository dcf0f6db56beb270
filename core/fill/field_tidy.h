// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fill/height_field.h"

namespace moldwright {

/// How much tidying may change, in grid steps.
struct TidyGoal {
    double shortEdge = 0; ///< shorter edges about walls are collapsed
    double flat = 0;      ///< points that filling made go where the surface moves by no more than this
};

/// Makes the triangles about walls rounder: collapses short edges, drops points of wall tops and feet that
/// lie nearly straight between others, turns edges of thin triangles, moves walls onto points that nearly
/// touch them. Elsewhere, and on the parting line, all stays as it is. Every triangle keeps running
/// counter-clockwise.
void tidy(HeightField& field, const TidyGoal& goal);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "deformation/clean_up.h"
#include "deformation/labelled_problem.h"

namespace moldwright::test {

/// A sphere of diameter 1 parted at its equator, points and all on one side keeping their indices.
LabelledSurface labelledBall(int rounds);

/// A solid box parted at z = 0 (two layers of cells below and above), its walls upright: they miss any draft.
LabelledBody labelledBox();

/// Labels by the mean height of each face's corners.
SideLabels labelsByHeight(const IndexedMesh& mesh);

/// Whether surface and parting line are sound: closed, manifold, no face on the wrong side of z = 0, the
/// line simple and nested.
bool soundlyParted(const LabelledSurface& surface);

/// Two cones base to base with a fin in the plane: by three points of the parting line its two sides lie one
/// upon the other. All faces have their draft.
[[nodiscard]] LabelledSurface finInThePlane();

} // namespace moldwright::test

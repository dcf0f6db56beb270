// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "field.h"

#include "mesh/indexed_mesh.h"

#include <Eigen/Geometry>

namespace moldwright::samples {

/// A solid to be meshed: a field, the box it lies in, and whether it is cut off flat by the plane z = 0.
struct Solid {
    Field field;
    Eigen::AlignedBox3d box; ///< mm; with a flat back only its part above z = 0 counts
    bool flatBack = false;
};

/// The surface of `solid` by marching tetrahedra (each cube of edge `cell` mm as six, so that neighbours
/// agree): closed, manifold, outward, but uneven. With a flat back every point of the back has z = 0
/// exactly. Features thinner than a cell are lost; the solid must not reach the sides of its box.
[[nodiscard]] IndexedMesh contour(const Solid& solid, double cell);

} // namespace moldwright::samples

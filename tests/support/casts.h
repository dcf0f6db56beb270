// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

namespace moldwright::test {

/// A castable shape whose numbers are known by hand, with the mold state it is castable in.
struct KnownCast {
    IndexedMesh mesh;
    MoldState state;
};

/// Two frusta joined at z = 0 on a rectangle a × b centred at the origin; heights up and down; walls lean
/// inwards by `lean` (tangent of the draft angle). 12 points, 20 faces. down = 0: flat-backed.
KnownCast frusta(double a, double b, double up, double down, double lean);

/// A sphere of radius r parted at its equator.
KnownCast ball(double r, int rounds);

/// A torus lying flat, parted at z = 0: two curves, one inside the other.
KnownCast ring(double ringRadius, double tubeRadius, int around, int across);

/// The upper half sheared by x += s1·z and the lower by x += s2·z; the directions follow.
KnownCast sheared(KnownCast cast, double s1, double s2);

/// Cast, plane and directions moved together: an oblique plane, coordinates rounded to floats.
KnownCast moved(KnownCast cast, const Eigen::Vector3d& axis, double angle, const Eigen::Vector3d& shift);

} // namespace moldwright::test

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "pins/medial_mesh.h"

#include <vector>

namespace moldwright::test {

/// Capsule about the z axis: a cylinder of half-length `half` with half balls at its ends; exactly symmetric.
IndexedMesh capsule(double radius, double half, int around, int along);

/// The unit sphere of `rounds` (see sphere()) stretched to semi-axes a, b, c.
IndexedMesh ellipsoid(double a, double b, double c, int rounds);

/// How far the solid that a medial axis fills misses the points: `outside` it the farthest, and the deepest
/// `inside` it.
struct Miss {
    double outside = 0;
    double inside = 0;
};
Miss missOf(const MedialMesh& axis, const Points& points);

/// The same for one point: negative inside what the axis fills.
double distanceFrom(const MedialMesh& axis, const Eigen::Vector3d& p);

/// The whole medial axis of a mesh, spikes and all, by samples of the seed; in the mesh's units.
MedialMesh wholeAxis(const IndexedMesh& mesh, unsigned seed = 1);

/// The same reduced to `count` balls.
MedialMesh reducedAxis(const IndexedMesh& mesh, int count, unsigned seed = 1);

/// Number of edges at each ball.
std::vector<int> degrees(const MedialMesh& axis);

} // namespace moldwright::test

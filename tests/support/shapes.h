// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <Eigen/Core>

namespace moldwright::test {

/// Box with corners lo and hi: 8 points, 12 faces, outward.
IndexedMesh box(const Eigen::Vector3d& lo, const Eigen::Vector3d& hi);

/// Sphere about c: an octahedron, `rounds` times split in four and pushed out; 2·4^(rounds+1) faces.
IndexedMesh sphere(const Eigen::Vector3d& c, double radius, int rounds);

/// Torus about the z axis at height 0: genus 1.
IndexedMesh torus(double ringRadius, double tubeRadius, int around, int across);

/// Both meshes in one, not joined.
IndexedMesh together(const IndexedMesh& a, const IndexedMesh& b);

/// Each edge split in the middle: every face becomes four, the shape stays.
IndexedMesh splitInFour(const IndexedMesh& mesh);

/// `mesh` rotated by `angle` radians about `axis` (unit) through the origin.
IndexedMesh rotated(const IndexedMesh& mesh, const Eigen::Vector3d& axis, double angle);

} // namespace moldwright::test

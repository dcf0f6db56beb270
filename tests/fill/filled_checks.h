// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fill/fill.h"

namespace moldwright::test {

/// Expects what fill() promises of every result: closed, manifold, outward, nothing crosses, every face looks
/// along its direction or square to it, the topological certificate holds, the parting line lies in the
/// plane.
void expectSound(const FilledPart& filled, const Directions& directions);

/// How many faces miss the draft angle.
int facesShort(const FilledPart& filled, const Directions& directions, double degrees);

/// Heights over the plane, along d, where the line through the plane's point (x, y) leaves the mesh,
/// ascending.
std::vector<double> crossings(const IndexedMesh& mesh, const Eigen::Vector2d& foot, const Eigen::Vector3d& d);

} // namespace moldwright::test

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/face_neighbours.h"

#include <Eigen/Core>

#include <vector>

namespace moldwright {

/// A place on a surface.
struct SurfacePlace {
    int face = 0;
    Eigen::Vector3d point; ///< on that face, mesh units
};

/// Length of the shortest way over the surface from a place to each point of the mesh, as far as `reach`
/// goes; infinity beyond. Ways run straight across faces: two faces at a time are laid flat together, so on
/// what can be unrolled the lengths are exact (close to `reach`, where long faces end beyond it, to some
/// thousandths), on round shapes within about a per cent of the right ones.
[[nodiscard]] std::vector<double> geodesicDistances(const FaceNeighbours& neighbours,
                                                    const SurfacePlace& from, double reach);

/// The faces whose middle is no farther than `radius` from a place, measured over the surface, and the face
/// of the place itself; ascending. What is near only through the air, or through the solid, is not among
/// them.
[[nodiscard]] std::vector<int> geodesicDisc(const FaceNeighbours& neighbours, const SurfacePlace& from,
                                            double radius);

} // namespace moldwright

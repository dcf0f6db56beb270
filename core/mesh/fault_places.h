// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/check.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace moldwright {

/// What is wrong at a place of a mesh that cannot be designed with.
enum class FaultKind {
    Hole,
    CrowdedEdge,     ///< more than two faces meet at an edge
    PinchedPoint,    ///< the surface touches itself in a point
    OneSided,        ///< two neighbours that cannot both look outward
    FaceWithoutArea, ///< its corners lie on a line
    Crossing,        ///< the surface crosses itself
    Enclosed         ///< a closed surface lies inside another
};
inline constexpr int faultKindCount = 7;

/// One place: faces and edges that are at fault in the same way and hang together.
struct FaultPlace {
    FaultKind kind = FaultKind::Hole;
    std::vector<int> faces;                ///< concerned, ascending
    std::vector<std::array<int, 2>> edges; ///< open, crowded, or of faces without area: by their points
    Eigen::AlignedBox3d box;               ///< about the edges, or else about the faces; mm
};

/// All places of examine()'s mesh where its diagnosis finds fault: by kind in the order of FaultKind, within
/// a kind the widest first. None for a mesh that was refused before it could be diagnosed.
[[nodiscard]] std::vector<FaultPlace> faultPlaces(const Examination& part);

} // namespace moldwright

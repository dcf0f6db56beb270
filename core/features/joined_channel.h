// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <optional>
#include <vector>

namespace moldwright {

/// What a joint of solids is held to.
struct JointRequest {
    Directions directions;
    double draftDegrees = 1;
    double grid = 0;
    /// Points at which a body will be open: faces with all corners among them need no draft.
    std::vector<Eigen::Vector3d> openings;
    /// The bodies are bores: what stands in them does not leave with the cast, so their walls need no draft.
    bool bores = false;
};

/// The cast with channels that cross it, as one closed solid. A union of graphs over the plane is one, so
/// nothing is lost but by rounding: where rounded points no longer give a sound solid, or a face falls below
/// the draft, the answer is none, and the caller moves the channel a little. Exact corefinement; only for
/// what really crosses.
[[nodiscard]] std::optional<IndexedMesh>
joinedSolid(const IndexedMesh& cast, const std::vector<IndexedMesh>& bodies, const JointRequest& request);

/// `mesh` without the faces whose corners are all among `points`.
[[nodiscard]] IndexedMesh openedAt(const IndexedMesh& mesh, const std::vector<Eigen::Vector3d>& points);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <optional>
#include <vector>

namespace moldwright {

/// A closed parting curve: its vertices in order, as the faces of side 1 run round them (side 1 on the left,
/// seen from outside).
using PartingCurve = std::vector<int>;

/// The chains of edges between faces of label 1 and of label 2, as closed curves; in order of their smallest
/// vertex, which comes first. None when a vertex has more than two such edges: then the curves touch
/// themselves. Precondition: closed, manifold, oriented; labels 1 and 2 only.
[[nodiscard]] std::optional<std::vector<PartingCurve>> partingCurves(const IndexedMesh& cast,
                                                                     const SideLabels& labels);

/// How the images of the curves lie, looking against a direction.
struct CurveNesting {
    bool simple = false;      ///< no image touches or crosses itself or another
    bool alternating = false; ///< counter-clockwise inside an even number of others, clockwise inside an odd
    std::vector<int> depth;   ///< per curve: inside how many others it lies; empty unless simple
};

/// Looks at the curves against d, or along it when `fromBelow`, so that the curves of a good cast turn the
/// same way for d1 and for d2. Exact. Near-linear by sweeping; curve by curve for the nesting.
[[nodiscard]] CurveNesting nestingAlong(const Points& V, const std::vector<PartingCurve>& curves,
                                        const Eigen::Vector3d& d, bool fromBelow = false);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <array>
#include <vector>

namespace moldwright {

/// One connected region of faces that collide with the mold.
struct Undercut {
    std::vector<int> faces;
    double area = 0;  ///< mm²
    double depth = 0; ///< mm: longest way along d, from the region's faces, that is blocked
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< mm, its area-weighted centre
    int side = 0;
};

/// Share of the area per draft class; edges in degrees, classes[k] = [edges[k], edges[k+1]).
struct DraftHistogram {
    static constexpr std::array<double, 13> edges = {-90, -60, -30, -15, -5, 0, 1, 2, 3, 5, 10, 30, 90};
    std::array<double, 12> areaFraction{};
};

/// Draft and undercuts of a mesh in a mold state. A face that crosses the plane counts as two pieces.
struct DraftAnalysis {
    double energy = 0; ///< Eq. (2) of [Stein 2019] at τ = sin(draft), for the mesh scaled to diagonal 1
    double worstDraftDegrees = 90;
    double violatingArea = 0;            ///< mm²
    double violatingAreaFraction = 0;    ///< of the whole area
    std::vector<double> faceDraft;       ///< degrees per face; of its worse piece
    std::vector<std::uint8_t> violating; ///< per face: 1 when a piece of it is below the draft angle
    std::vector<Undercut> undercuts;     ///< largest area first
    DraftHistogram histogram;

    [[nodiscard]] bool castable() const { return violatingArea == 0; }
};

/// Analyses `mesh`. `withDepths` also measures undercut depths (slower: rays). O(m).
[[nodiscard]] DraftAnalysis analyzeDraft(const IndexedMesh& mesh, const MoldState& state, double draftDegrees,
                                         bool withDepths = true);

/// How far each face's undercut is blocked, mm: from its middle along the direction of its side to the
/// outermost face over it; 0 for faces that are no undercut. The largest of a region is its Undercut::depth.
[[nodiscard]] std::vector<double> undercutDepths(const IndexedMesh& mesh, const MoldState& state,
                                                 double draftDegrees);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <string>
#include <vector>

namespace moldwright {

/// The proof that a cast leaves both mold halves, or why it is not one.
struct Certificate {
    bool closedAndOutward = false; ///< closed, manifold, positive volume
    bool directionsLeave = false;  ///< d1·n > 0 and d2·n < 0
    bool draftHolds = false;       ///< every face of side i: N·d_i ≥ sin(draft), exactly
    bool curvesOnPlane =
        false; ///< no face on the wrong side: parting curves within 4 float ulps of the plane
    bool curvesSimpleAndNested =
        false; ///< along d1 and along d2: simple, not crossing, alternating with nesting
    bool selfIntersectionFree = false; ///< no two faces cross (exact predicates)
    std::vector<int> violatingFaces;
    double worstDraftDegrees = 0; ///< rounded down
    std::string reason;           ///< English; empty when it holds

    [[nodiscard]] bool holds() const {
        return closedAndOutward && directionsLeave && draftHolds && curvesOnPlane && curvesSimpleAndNested &&
               selfIntersectionFree;
    }
};

/// τ for a draft angle: a double a few ulps above sin(draft), so that exact tests against it prove the angle.
[[nodiscard]] double provableTolerance(double draftDegrees);

/// How far off a plane a point of `cast` may lie and still count as on it, mm: 4 ulps of a float as large as
/// the largest coordinate, which is what rounding to floats can move a point by, with room.
[[nodiscard]] double onPlaneTolerance(const IndexedMesh& cast);

/// Proves in exact arithmetic, on the coordinates as given (round to float first for what an STL holds), that
/// `cast` is castable in `state` with the draft angle. For each face of label i with c = (b−a)×(c−a): c·d_i >
/// 0 and (c·d_i)² ≥ τ²|c|²|d_i|², rational τ ≥ sin draft. See ARCHITECTURE.md, "The certificate".
[[nodiscard]] Certificate certify(const IndexedMesh& cast, const SideLabels& labels, const MoldState& state,
                                  double draftDegrees);

/// Side of each face of a cast whose parting line is inserted: by its points' distances from the plane,
/// points within 4 float ulps of the largest coordinate counting as on it; a face wholly on it by its normal.
/// A face with points strictly on both sides gets the label 0: no certificate can hold.
[[nodiscard]] SideLabels labelSides(const IndexedMesh& cast, const PartingPlane& plane);

} // namespace moldwright

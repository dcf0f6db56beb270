// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "features/drafted_prism.h"
#include "mesh/indexed_mesh.h"

#include <array>
#include <memory>
#include <optional>

namespace moldwright {

/// A hole through a mold half along its removal direction, from a high point of the cavity to the block's
/// outer face; it narrows outwards, since what solidifies in it must leave with the cast.
struct ThroughVent {
    int side = 1;
    DraftedPrism body;                               ///< stands `foot` above the plane instead of on it
    double foot = 0;                                 ///< mm from the plane, inside the cavity
    Eigen::Vector3d mouth = Eigen::Vector3d::Zero(); ///< centre of the opening, mm, mold's frame
    double reach = 0; ///< mm along `up`: the highest point at which air enters it

    /// The body closed, in the mold's frame.
    [[nodiscard]] IndexedMesh solid() const;
};

/// What is asked of a vent.
struct ThroughVentRequest {
    double diameter = 1.5; ///< mm at the mouth, its narrowest
    double end = 0;        ///< distance of the block's outer face from the plane, mm
    double draftDegrees = 1;
    double grid = 0;
    int quartersAway = 0;  ///< quarters of its radius, from the high point, at which the search begins
    int quartersMost = 16; ///< and at which it ends
};

/// Finds vents through the halves for the air in one cast.
class ThroughVents {
public:
    /// In the mold's frame, plane z = 0. Both must outlive this.
    ThroughVents(const IndexedMesh& cast, const SideLabels& labels, const Directions& directions);
    ~ThroughVents();

    /// A vent for the air at `highPoint`, a point of the cast on the given side: its foot lies wholly inside
    /// the cast, as near to the point as that allows, so that the joined body is still a graph along the
    /// direction. `up` (unit) may point any way. None where the cast is too slender for the foot. The first
    /// of a side takes O(m).
    [[nodiscard]] std::optional<ThroughVent> from(int side, const Eigen::Vector3d& highPoint,
                                                  const Eigen::Vector3d& up,
                                                  const ThroughVentRequest& request);

private:
    class InsideSide;
    [[nodiscard]] const InsideSide& inside(int side);

    const IndexedMesh& m_cast;
    const SideLabels& m_labels;
    Directions m_directions;
    std::array<std::unique_ptr<InsideSide>, 2> m_inside;
};

} // namespace moldwright

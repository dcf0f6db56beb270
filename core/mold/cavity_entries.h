// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/bore_places.h"
#include "mold/cavity_joints.h"

#include <memory>
#include <vector>

namespace moldwright {

/// The kinds of cavities of one mold, and the ground that holes can enter them by: what does not depend on
/// where any feature stands.
struct CavityShapes {
    std::vector<CavityKind> kinds;
    std::vector<BoreGround> pinGrounds;                ///< by kind; empty without ejector pins
    std::vector<std::vector<BoreGround>> spoutGrounds; ///< by kind and solid; empty without through spouts

    /// Precondition: this stays where it is, for the grounds refer to the kinds.
    void findGrounds(const MoldSettings& settings, const Directions& directions);
};

/// What the places of entries follow from besides.
struct EntryPlan {
    const MoldSettings* settings = nullptr;
    Directions directions;
    double gate = 0;                               ///< mm, width of gates in the parting plane
    double channelDraft = 0;                       ///< degrees
    Eigen::Vector3d up = Eigen::Vector3d::UnitY(); ///< while it is filled
    bool tellsAir = false;                         ///< the traps are asked for even where nothing serves them
    /// Where each kind's gates are spouts of their own, which a hand may move: its only copy's place, mm.
    /// Else empty.
    std::vector<Eigen::Vector2d> cavityAt;
};

/// Where each kind is filled, what air stays then, and where it is pushed out: by hand or found. Errors:
/// Impossible, where there is no place, or none where a hand put it.
[[nodiscard]] Result<std::vector<CavityFeatures>> entriesOf(const CavityShapes& shapes,
                                                            const EntryPlan& plan);

} // namespace moldwright

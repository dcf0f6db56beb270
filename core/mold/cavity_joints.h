// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "features/half_bore.h"
#include "features/through_vent.h"
#include "mold/channels.h"
#include "mold/gates.h"

#include <vector>

namespace moldwright {

/// A trap that has no vent, or air that stays above one.
struct RemainingAir {
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< mm, the kind's coordinates
    double volume = 0;                               ///< mm³
};

/// A trap that is to be vented, and the place of the cavity from which the air shall leave.
struct VentedTrap {
    AirTrap trap;
    Eigen::Vector3d top =
        Eigen::Vector3d::Zero(); ///< mm, the kind's coordinates: its highest point as a rule
    int number = 0;              ///< among those of all kinds
    bool byHand = false;         ///< the top was chosen: it stands there or nowhere
};

/// A vent through a half.
struct CavityVent : ThroughVent {
    int number = 0;                                ///< of its trap
    Eigen::Vector2d top = Eigen::Vector2d::Zero(); ///< the trap's, mm
};

/// A closed well beside the cavity, in the kind's coordinates: where its channel leaves the parting line, and
/// which way.
struct Overflow {
    Eigen::Vector2d tip = Eigen::Vector2d::Zero();    ///< mm, on the parting line
    Eigen::Vector2d way = Eigen::Vector2d::UnitY();   ///< unit, outwards
    Eigen::Vector2d stands = Eigen::Vector2d::Zero(); ///< the place that it has by hand; else the tip
    double drop = 0;                                  ///< mm inside the tip at which the channel begins
    double exit = 0; ///< mm beyond it at which the channel has left the outline
    int number = 0;  ///< among those of all kinds
};

/// The same as bodies; the channel opens into the well's first wall.
struct JoinedOverflow {
    DraftedPrism channel;
    DraftedPrism well;
    int number = 0;
    Eigen::Vector2d tip = Eigen::Vector2d::Zero();    ///< mm
    Eigen::Vector2d stands = Eigen::Vector2d::Zero(); ///< mm
};

/// One kind of cavity with everything that crosses its wall.
struct JoinedCavity {
    IndexedMesh solid; ///< cast, stubs and vents in one; open where stubs go on
    std::vector<Stub> stubs;
    std::vector<CavityVent> vents;
    std::vector<JoinedOverflow> overflows; ///< of them `solid` holds the channels
    std::vector<RemainingAir> remaining;
    double stubVolume = 0;       ///< mm³ by which the closed solid is larger than the cast
    IndexedMesh hollow;          ///< the solid with its bores: what the halves are cut by; open like it
    std::vector<HalfBore> bores; ///< as they were joined
    double spoutVolume = 0;      ///< mm³ of the bores that fill
    double pinVolume = 0;        ///< mm³ of those that do not
};

/// What crosses one kind's wall.
struct CavityFeatures {
    std::vector<Gate> gates;
    std::vector<VentedTrap> traps;
    std::vector<AirTrap> unvented; ///< where they are asked for without vents
    std::vector<HalfBore> bores;   ///< their last section is left to the joint: the block's face
};

/// What a cavity is joined with.
struct JointPlan {
    const MoldSettings* settings = nullptr;
    ChannelRules rules;
    ChannelWidths widths;
    double draftDegrees = 1;                       ///< of the mold
    Eigen::Vector3d up = Eigen::Vector3d::UnitY(); ///< while it is filled; unit
    double line = 0;                  ///< at which stubs end, along the kind's inlet, its coordinates
    std::array<double, 2> slope{};    ///< of the wall that they end in
    std::vector<Overflow> overflows;  ///< of this kind
    bool spout = false;               ///< its gates are spouts themselves
    bool ventsInPlane = true;         ///< nothing else stands over the cavity
    std::vector<PlanShape> others;    ///< what vents in the plane keep clear of, the kind's coordinates
    std::array<double, 2> blockEnd{}; ///< distance of the block's outer faces from the plane, mm
};

/// Gates, vents and bores of one kind as they will be joined, without the joint: the result's solids are
/// empty. Errors: Impossible (with the place) where a way is not free or a vent by hand cannot stand there.
[[nodiscard]] Result<JoinedCavity> plannedCavity(const CavityKind& kind, const CavityFeatures& features,
                                                 const JointPlan& plan);

/// How often a joint is tried, and how far aside each time, of the channel's width.
inline constexpr int jointAttempts = 10;
inline constexpr double jointNudge = 0.011;

/// Gates, vents and bores of one kind, joined to it exactly. Where rounding spoils a joint the channel is
/// moved by hundredths of its width and joined again. Errors: as plannedCavity(), and Impossible when that
/// never helps.
[[nodiscard]] Result<JoinedCavity> joinedCavity(const CavityKind& kind, const CavityFeatures& features,
                                                const JointPlan& plan);

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/bolt_holes.h"
#include "mold/bore_places.h"
#include "mold/cavity_joints.h"
#include "mold/half.h"
#include "mold/mold.h"
#include "mold/registration.h"

#include <optional>
#include <vector>

namespace moldwright {

/// Builds a mold stage by stage, in the order of the members; each uses what the ones before have found. Only
/// mold.cpp calls it.
class MoldBuilder {
public:
    MoldBuilder(const MoldSettings& settings, double draftDegrees);

    /// The cast larger by the shrink, in the mold's frame, the pour direction up in the plane (+y).
    Result<void> place(const IndexedMesh& cast, const SideLabels& labels, const MoldState& state);
    /// Kinds of cavities, their places, and the room that channels need.
    Result<void> layOut();
    /// Block, keys and slits; the block grows until all have room.
    Result<void> fitBlock();
    /// What crosses a cavity's wall, and the runners.
    Result<void> join();
    /// Everything that solidifies, and the halves about it.
    Result<void> assemble();
    /// Volumes, areas, steel.
    Result<void> measure();
    Result<void> prove();

    [[nodiscard]] Mold mold() { return std::move(m_mold); }
    [[nodiscard]] const Block& block() const { return m_block; }

private:
    [[nodiscard]] bool single() const { return m_layout.copies.size() == 1; }
    /// Whether spout and runners lie in the parting plane.
    [[nodiscard]] bool inPlane() const { return spout().on && spout().resting == Resting::Standing; }
    [[nodiscard]] bool lying() const { return spout().on && spout().resting == Resting::Lying; }
    /// Up while the mold is filled.
    [[nodiscard]] Eigen::Vector3d up() const {
        return lying() ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
    }
    [[nodiscard]] const SpoutSettings& spout() const { return m_mold.settings.spout; }
    [[nodiscard]] bool channels() const { return spout().on || m_mold.settings.vents.on; }
    Result<void> placeEntries(std::size_t kind);
    Result<void> placeEjectors(std::size_t kind);
    Result<std::vector<int>> placeSpouts(std::size_t kind);
    [[nodiscard]] Obstacles planObstacles(const Block& block) const;
    void addChannelObstacles(Obstacles& obstacles, double faceY) const;
    /// A hole that leaves a cavity through a half, along its direction.
    struct OutwardHole {
        Eigen::Vector3d foot;
        int side;
        double radius;
    };
    [[nodiscard]] std::vector<OutwardHole> outwardHoles(const CavityCopy& copy) const;
    [[nodiscard]] Eigen::Vector3d mouthOf(const OutwardHole& hole, const Eigen::AlignedBox3d& block) const;
    [[nodiscard]] std::optional<Block> blockFor(double wallX, double wallY) const;
    [[nodiscard]] bool placeOn(const Block& block);
    Result<void> makeRegistration();
    Result<void> addTails();
    void addHalf(int side, HalfSurfaces& half, std::vector<PlacedSurface>& solids);
    void listFeatures();
    void listCavity(const CavityCopy& copy);
    void listChannels();
    void listRegistration();
    void listBores(const CavityCopy& copy);
    void listBolts();
    [[nodiscard]] std::vector<Hollow> hollows() const;

    Mold m_mold;
    double m_grid = 0;
    ChannelRules m_rules;
    ChannelWidths m_widths;
    IndexedMesh m_cast; ///< placed
    SideLabels m_labels;
    std::vector<CavityKind> m_kinds;
    std::vector<std::vector<Gate>> m_gates;     ///< by kind, if a spout lies in the plane
    std::vector<std::vector<AirTrap>> m_traps;  ///< by kind, if there are vents
    std::vector<std::vector<HalfBore>> m_bores; ///< by kind
    Layout m_layout;
    Block m_block;
    std::vector<Eigen::Vector2d> m_boltPlaces;
    std::vector<PlanShape> m_bolts; ///< outlines
    std::vector<Eigen::Vector2d> m_keyPlaces;
    std::vector<Eigen::Vector2d> m_slitPlaces;
    std::vector<RegistrationKey> m_keys;
    std::vector<WedgeSlit> m_slits;
    FaceEnd m_end;
    std::vector<JoinedCavity> m_joined;
    std::vector<std::vector<Stub>> m_stubs; ///< by kind
    RunnerNet m_net;
    std::vector<DraftedPrism> m_closedTails;
    std::vector<DraftedPrism> m_openTails;
};

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/bolt_holes.h"
#include "mold/cavity_entries.h"
#include "mold/cavity_joints.h"
#include "mold/half.h"
#include "mold/mold.h"
#include "mold/plaque.h"
#include "mold/pockets.h"
#include "mold/pour_tilt.h"
#include "mold/registration.h"
#include "mold/shrink.h"
#include "mold/tray.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace moldwright {

/// Builds a mold stage by stage, in the order of the members; each uses what the ones before have found. Only
/// mold.cpp calls it, and mold_sketch.cpp as far as planJoints() and measureSteel().
class MoldBuilder {
public:
    MoldBuilder(const MoldSettings& settings, double draftDegrees);

    /// The casts larger by the shrink, in the mold's frame, the pour direction up in the plane (+y).
    Result<void> place(const Tray& tray);
    /// Kinds of cavities, and what of them does not depend on where features stand.
    Result<void> makeKinds();
    /// How the mold leans while it is filled.
    Result<void> findTilt();
    /// What stands by hand, if that is to be other than in the settings.
    Result<void> setPlaced(const PlacedFeatures& placed);
    /// The cavities' places, and the room that channels need.
    Result<void> layOut();
    /// Of what stands by hand, what the entries of cavities follow from. Precondition: layOut().
    [[nodiscard]] PlacedFeatures placedAtCavities() const;
    /// Where cavities are filled, vented, and pushed out.
    Result<void> findEntries();
    /// Wells beside the cavities.
    Result<void> findOverflows();
    /// Block, keys and slits; the block grows until all have room.
    Result<void> fitBlock();
    /// What air leaning saves, or would.
    Result<void> tellOfTilt();
    /// What will cross a cavity's wall, and the runners.
    Result<void> planJoints() { return makeJoints(&plannedCavity); }
    /// The same, joined to the cavities.
    Result<void> join() { return makeJoints(&joinedCavity); }
    /// The steel between all of this, and the list of features.
    Result<void> measureSteel();
    /// Refuses features that meet, by their names.
    Result<void> refuseCollisions();
    /// Everything that solidifies, and the halves about it.
    Result<void> assemble();
    /// Volumes and areas.
    Result<void> measure();
    Result<void> prove();

    [[nodiscard]] Mold mold() { return std::move(m_mold); }
    [[nodiscard]] const Block& block() const { return m_block; }

    /// Of all cavities, mold's frame. Precondition: layOut().
    [[nodiscard]] std::vector<PlanShape> partingLines() const;

    using Entries = std::shared_ptr<const std::vector<CavityFeatures>>;
    [[nodiscard]] const Entries& entries() const { return m_entries; }
    /// Instead of findEntries(): those of the same mold with the same entries by hand.
    void useEntries(const Entries& entries) { m_entries = entries; }

private:
    [[nodiscard]] const std::vector<CavityKind>& kinds() const { return m_shapes->kinds; }
    [[nodiscard]] bool single() const { return m_layout.copies.size() == 1; }
    /// Whether the cavities stand on a circle.
    [[nodiscard]] bool star() const {
        return m_seats.layout.arrangement == Arrangement::Circle && m_seats.partAt.size() > 1;
    }
    [[nodiscard]] bool isFree() const { return m_mold.settings.layout.arrangement == Arrangement::Free; }
    /// Whether the ways to cavities in rows and columns are of one length.
    [[nodiscard]] bool balanced() const {
        const LayoutSettings& layout = m_seats.layout;
        return spout().runners == Runners::Balanced && inPlane() && !star() && !isFree() &&
               layout.rows * layout.columns > 1;
    }
    /// Whether all of the runners and their spout are one prism, which stands where the cavities ask for it.
    [[nodiscard]] bool inOnePrism() const { return star() || balanced(); }
    /// Whether a spout in the parting plane leads to each cavity without runners.
    [[nodiscard]] bool spoutEach() const { return single() || isFree(); }
    /// Whether spout and runners lie in the parting plane.
    [[nodiscard]] bool inPlane() const { return spout().on && spout().resting == Resting::Standing; }
    [[nodiscard]] bool lying() const { return spout().on && spout().resting == Resting::Lying; }
    /// Up while the mold is filled.
    [[nodiscard]] Eigen::Vector3d up() const {
        return upWhenLeaning(lying() ? Resting::Lying : Resting::Standing, m_tilt.degrees, m_tilt.towards);
    }
    [[nodiscard]] Result<double> airWhenLeaning(const PourTilt& tilt) const;
    [[nodiscard]] std::optional<LeaningMold> bestLean() const;
    [[nodiscard]] const SpoutSettings& spout() const { return m_mold.settings.spout; }
    [[nodiscard]] bool channels() const { return spout().on || m_mold.settings.vents.on; }
    [[nodiscard]] bool isByHand(Placeable kind, int number) const;
    Result<void> makeJoints(Result<JoinedCavity> (*joined)(const CavityKind&, const CavityFeatures&,
                                                           const JointPlan&));
    Result<void> placeFirst(const CompensatedCast& cast, const SideLabels& labels);
    [[nodiscard]] int quartersUp(const IndexedMesh& cast, const SideLabels& labels) const;
    [[nodiscard]] CavityRules cavityRules() const { return {m_mold.directions, m_mold.draftDegrees, m_grid}; }
    [[nodiscard]] Result<std::vector<CavityKind>> kindsAsked() const;
    [[nodiscard]] std::vector<std::size_t> kindAt() const;
    [[nodiscard]] std::array<bool, 2> sidesOfChannels() const;
    [[nodiscard]] Result<Layout> layoutAsked() const;
    [[nodiscard]] Result<Layout> layoutOnCircle() const;
    [[nodiscard]] Result<JointPlan> jointPlan(std::size_t kind) const;
    [[nodiscard]] double endOfStubs(std::size_t kind) const;
    [[nodiscard]] std::vector<PlanShape> standingBeside(std::size_t kind) const;
    [[nodiscard]] double widestOfSpout() const { return std::max(spout().funnel, spout().diameter); }
    [[nodiscard]] Obstacles planObstacles(const Block& block) const;
    [[nodiscard]] std::vector<PlanShape> gateShapes(const CavityCopy& copy) const;
    void addChannelObstacles(Obstacles& obstacles, double faceY) const;
    void addRunnerObstacles(Obstacles& obstacles) const;
    void addVentObstacles(Obstacles& obstacles, const CavityCopy& copy, double end) const;
    void addChannelContent(BlockContent& content, double wallY) const;
    void addRunnerContent(BlockContent& content, double wallY) const;
    void addTreeContent(BlockContent& content, double wallY) const;
    void addByHand(Obstacles& obstacles, const Block& block) const;
    [[nodiscard]] Eigen::AlignedBox2d boxByHand() const;
    /// A hole that leaves a cavity through a half, along its direction.
    struct OutwardHole {
        Eigen::Vector3d foot;
        int side;
        double radius;
    };
    [[nodiscard]] std::vector<OutwardHole> outwardHoles(const CavityCopy& copy) const;
    /// `end`: z of the half's back.
    [[nodiscard]] Eigen::Vector3d mouthOf(const OutwardHole& hole, double end) const;
    [[nodiscard]] std::array<double, 2> depthOfChannels() const;
    [[nodiscard]] Result<Block> blockFor(double wallX, double wallY) const;
    [[nodiscard]] Result<double> tail() const;
    Result<void> cutShell();
    [[nodiscard]] bool placeOn(const Block& block);
    Result<void> makeRegistration();
    /// The lettering in the backs.
    Result<void> engrave();
    [[nodiscard]] Obstacles openingsInBack(int side) const;
    Result<void> addTails();
    void tellOfNarrowGates();
    void tellOfSpoutByHand();
    void addHalf(int side, HalfSurfaces& half, std::vector<PlacedSurface>& solids);
    void listFeatures();
    void listCavity(std::size_t number);
    void listStubs(const CavityCopy& copy);
    void listChannels();
    void comparePaths();
    void listOverflows(const CavityCopy& copy);
    void listRegistration();
    void listBores(const CavityCopy& copy);
    void listBolts();
    void listPockets();
    void listPlaques();
    void addPlaceable(MoldFeature feature, const PlacedFeature& stands, PlanShape outline,
                      const Eigen::Vector2d& origin = Eigen::Vector2d::Zero());
    [[nodiscard]] std::vector<Hollow> hollows() const;
    [[nodiscard]] std::vector<PlanShape> besideOverflows(std::size_t kind) const;
    [[nodiscard]] std::vector<PlanShape> overflowShapes(const CavityCopy& copy) const;
    void addOverflows(std::vector<Hollow>& all) const;
    Result<void> addOverflowSurfaces(int side, HalfSurfaces& half, std::vector<PlacedSurface>& solids) const;
    [[nodiscard]] Message collision(const ThinSteel& thin) const;
    [[nodiscard]] std::vector<Hollow> attachedTo(std::size_t kind, int net) const;
    [[nodiscard]] SharedMesh sprues() const;
    void measureParts();
    void compareWithMachines();

    Mold m_mold;
    PourTilt m_tilt;
    bool m_tellsAir = false; ///< traps are found even where nothing serves them
    double m_grid = 0;
    double m_farthest = 0; ///< mm from the middle at which a feature may stand
    ChannelRules m_rules;
    ChannelWidths m_widths;
    SeatedLayout m_seats;
    std::vector<CavityKind> m_parts; ///< of the tray, as they were placed, until the kinds are known
    std::shared_ptr<const CavityShapes> m_shapes;
    Entries m_entries;                              ///< by kind
    std::vector<std::vector<Overflow>> m_overflows; ///< by kind
    std::shared_ptr<SteelTrees> m_trees;            ///< shared by copies of this builder
    Layout m_layout;
    Block m_block;
    std::vector<Eigen::Vector2d> m_boltPlaces;
    std::vector<PlanShape> m_bolts; ///< outlines
    std::vector<Eigen::Vector2d> m_keyPlaces;
    std::vector<Eigen::Vector2d> m_slitPlaces;
    std::vector<RegistrationKey> m_keys;
    std::vector<WedgeSlit> m_slits;
    std::vector<Eigen::Vector2d> m_pocketPlaces;
    std::vector<InsertPocket> m_pockets;
    std::vector<Plaque> m_plaques; ///< of half 1 and 2, if there are any
    FaceEnd m_end;
    std::vector<JoinedCavity> m_joined;
    std::vector<std::vector<Stub>> m_stubs; ///< by kind
    RunnerNet m_net;
    std::vector<DraftedPrism> m_closedTails;
    std::vector<DraftedPrism> m_openTails;
};

} // namespace moldwright
